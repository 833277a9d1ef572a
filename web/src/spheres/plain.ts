// Draws packings of spheres without a graphics card: far things first, each sphere a picture made once per colour.
import { heat } from "../theme";
import { boxEdges } from "./box";
import { SHRINK } from "./gl";
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
  size: number,
  scene: Scene,
  view: View,
  look: Look,
  most = Infinity,
): void {
  const lens = lensOf(scene, view, look);
  const half = size / 2;
  const x = (p: number[]) => half + (half * lens.scale * p[0]) / (lens.eye - p[2]);
  const y = (p: number[]) => half - (half * lens.scale * p[1]) / (lens.eye - p[2]);
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
  ctx.fillRect(0, 0, size, size);
  ctx.lineCap = "round";
  for (const [a, b] of boxEdges(scene))
    rod(rotate(view.rotation, ...a), rotate(view.rotation, ...b), "#858f9e", 0.0064 * scene.reach);
  if (look.what !== "grains")
    for (let k = Math.max(scene.contacts.length - PER_CONTACT * most, 0); k < scene.contacts.length; k += PER_CONTACT) {
      const c = scene.contacts;
      if (c[k + 6] < look.least) continue;
      const a = rotate(view.rotation, c[k], c[k + 1], c[k + 2]);
      const b = rotate(view.rotation, c[k + 3], c[k + 4], c[k + 5]);
      const middle = a.map((v, axis) => (v + b[axis]) / 2);
      if (middle[2] > lens.front) continue;
      const [colour, width] = [heat(c[k + 6] / 4), 0.024 + 0.068 * Math.min(c[k + 6], 5)];
      for (const end of [a, b]) rod(end, middle, colour, width, Math.min(end[2], middle[2]) - 0.01); // behind its grain
    }
  if (look.what === "grains" || (look.what === "both" && most === Infinity))
    for (let k = 0; k < scene.strongest.length; ++k) {
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
