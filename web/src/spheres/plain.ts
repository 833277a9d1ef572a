// Draws packings of spheres and clusters without a graphics card: far things first, each sphere a picture made once per
// colour, arms of clusters in short pieces.
import { PER_ARM, STRONGEST_STRESS } from "../clusters";
import { heat, shaded } from "../theme";
import { fineLine, outline } from "./box";
import { SHRINK, SHRINK_ARM } from "./gl";
import { PER_CONTACT, PER_GRAIN, type Scene } from "./scene";
import { lensOf, rotate, type Look, type View } from "./view";

const CLASSES = 12;
const SPRITE = 64;
const sprites = new Map<string, HTMLCanvasElement>();

/** A shaded ball of one colour. */
function sprite(colour: string): HTMLCanvasElement {
  let canvas = sprites.get(colour);
  if (canvas) return canvas;
  canvas = document.createElement("canvas");
  canvas.width = canvas.height = SPRITE;
  const ctx = canvas.getContext("2d")!;
  const middle = SPRITE / 2;
  ctx.beginPath();
  ctx.arc(middle, middle, middle - 1, 0, 2 * Math.PI);
  ctx.fillStyle = colour;
  ctx.fill();
  const light = ctx.createRadialGradient(middle * 0.7, middle * 0.6, 0, middle, middle, middle);
  light.addColorStop(0, "rgba(255,255,255,0.45)");
  light.addColorStop(0.5, "rgba(255,255,255,0)");
  light.addColorStop(1, "rgba(20,30,50,0.45)");
  ctx.fillStyle = light;
  ctx.fill();
  sprites.set(colour, canvas);
  return canvas;
}

interface Item {
  z: number;
  draw(): void;
}

/** Of the contacts at most the `most` strongest, and then no grains beside them. */
export function drawPlain(
  ctx: CanvasRenderingContext2D,
  scene: Scene,
  view: View,
  look: Look,
  most = Infinity,
): void {
  const lens = lensOf(scene, view, look);
  const { width, height } = ctx.canvas;
  const half = Math.max(width, height) / 2;
  const x = (p: number[]) => width / 2 + (half * lens.scale * p[0]) / (lens.eye - p[2]);
  const y = (p: number[]) => height / 2 - (half * lens.scale * p[1]) / (lens.eye - p[2]);
  const pixels = (length: number, z: number) => (half * lens.scale * length) / (lens.eye - z);
  const pale = (z: number) => 1 - 0.45 * Math.min(Math.max((scene.reach - z) / (2 * scene.reach), 0), 1) ** 2;
  const items: Item[] = [];
  const rod = (a: number[], b: number[], colour: string, width: number, z = (a[2] + b[2]) / 2) => {
    items.push({
      z,
      draw: () => {
        ctx.globalAlpha = pale(z);
        ctx.strokeStyle = colour;
        ctx.lineWidth = Math.max(pixels(width, z), 0.5);
        ctx.beginPath();
        ctx.moveTo(x(a), y(a));
        ctx.lineTo(x(b), y(b));
        ctx.stroke();
      },
    });
  };

  ctx.fillStyle = "#fff";
  ctx.fillRect(0, 0, width, height);
  ctx.lineCap = "round";
  for (const [a, b] of outline(scene))
    rod(rotate(view.rotation, ...a), rotate(view.rotation, ...b), scene.cylinder ? "#bcc4ce" : "#858f9e", 2 * fineLine(scene));
  if (look.what !== "grains")
    for (let k = Math.max(scene.contacts.length - PER_CONTACT * most, 0); k < scene.contacts.length; k += PER_CONTACT) {
      const c = scene.contacts;
      if (c[k + 6] < look.least) continue;
      const a = rotate(view.rotation, c[k], c[k + 1], c[k + 2]);
      const b = rotate(view.rotation, c[k + 3], c[k + 4], c[k + 5]);
      const middle = a.map((v, axis) => (v + b[axis]) / 2);
      if (middle[2] > lens.front) continue;
      const [colour, width] = [heat(c[k + 6] / 4), scene.unit * (0.024 + 0.068 * Math.min(c[k + 6], 5))];
      for (const end of [a, b]) rod(end, middle, colour, width, Math.min(end[2], middle[2]) - 0.01); // behind its grain
    }
  const bodies = look.what === "grains" || (look.what === "both" && most === Infinity);
  const mostPieces = scene.arms.length > 5000 * PER_ARM ? 2 : 8;
  if (bodies)
    for (let k = 0; k < scene.arms.length; k += PER_ARM) {
      const arm = scene.arms.subarray(k, k + PER_ARM);
      const a = rotate(view.rotation, arm[0], arm[1], arm[2]);
      const b = rotate(view.rotation, arm[3], arm[4], arm[5]);
      if ((a[2] + b[2]) / 2 > lens.front) continue;
      const colour = scene.tint ?? (look.what === "both" ? "#ccd5df" : arm[7] > 0 ? heat(arm[7] / STRONGEST_STRESS) : "#edf1f5");
      const thick = arm[6] * (look.what === "both" ? SHRINK_ARM : 1);
      const length = Math.hypot(...a.map((v, axis) => v - b[axis]));
      const pieces = Math.min(Math.max(Math.ceil(length / (1.2 * arm[6])), 1), mostPieces);
      const cut = (part: number) => a.map((v, axis) => v + part * (b[axis] - v));
      for (let piece = 0; piece < pieces; ++piece) {
        const [from, to] = [cut(piece / pieces), cut((piece + 1) / pieces)];
        const z = (from[2] + to[2]) / 2;
        items.push({
          z,
          draw: () => {
            const line = 2 * pixels(thick, z);
            const stroke = (style: string, part: number) => {
              ctx.strokeStyle = style;
              ctx.lineWidth = Math.max(part * line, 0.5);
              ctx.beginPath();
              ctx.moveTo(x(from), y(from));
              ctx.lineTo(x(to), y(to));
              ctx.stroke();
            };
            ctx.globalAlpha = 1;
            stroke(shaded(colour, 0.66), 1);
            stroke(colour, 0.78);
            stroke(shaded(colour, 1.14), 0.3);
          },
        });
      }
    }
  if (bodies)
    for (let k = 0; k < scene.grains.length / PER_GRAIN; ++k) {
      const g = scene.grains.subarray(PER_GRAIN * k, PER_GRAIN * (k + 1));
      const at = rotate(view.rotation, g[0], g[1], g[2]);
      if (at[2] > lens.front) continue;
      const radius = pixels(look.what === "both" ? g[3] * SHRINK : g[3], at[2]);
      const force = Math.round((Math.min(scene.strongest[k], 4) / 4) * CLASSES) / CLASSES;
      const colour = scene.strongest[k] < 0 ? "#edf1f5" : look.what === "both" ? "#ccd5df" : heat(force);
      const ball = sprite(colour);
      items.push({
        z: at[2],
        draw: () => {
          ctx.globalAlpha = 1;
          ctx.drawImage(ball, x(at) - radius, y(at) - radius, 2 * radius, 2 * radius);
        },
      });
    }
  items.sort((a, b) => a.z - b.z);
  for (const item of items) item.draw();
  ctx.globalAlpha = 1;
}
