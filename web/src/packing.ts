// Draws one packing in two dimensions with its force network: grains as discs or clusters of arms, contacts as lines whose
// width and colour follow the force.
import { armsOf, lineUnit, PER_ARM, positionOf, STRONGEST_STRESS } from "./clusters";
import type { NetworkFrame } from "./data";
import { longs, words } from "./packed";
import { pixelRatio } from "./pixel_ratio";
import type { Look } from "./spheres/view";
import { heat, shaded } from "./theme";

/** Forces above this many mean forces are drawn alike (S1 clamps there too). */
export const STRONGEST = 5;
/** Line width per mean force, in units of the mean grain diameter. */
const WIDTH = 0.15;

const COLOURS = 32;

export function forceColour(force: number): string {
  return heat(force / 4);
}

/** How many times the picture of a packing is higher than wide: containers are higher. */
export function packingAspect(frame: NetworkFrame): number {
  if (!frame.clusters) return 1;
  const [across, up] = [0, 1].map((a) => frame.upper[a] - frame.lower[a]);
  return Math.min(Math.max(up / across, 1), 2);
}

type Place = (position: number) => number;

/** Arms as thick lines, with a contour that leaves out what lies inside a body. `colour` is that of a stress. */
function drawClusters(
  ctx: CanvasRenderingContext2D,
  frame: NetworkFrame,
  scale: number,
  [x, y]: [Place, Place],
  colour: (stress: number) => string,
): void {
  const arms = armsOf(frame, [0, 0, 0]);
  const contour = Math.min(Math.max(0.06 * scale, 0.4 * pixelRatio), 1.5 * pixelRatio);
  ctx.lineCap = "round";
  for (const inside of [false, true])
    for (let k = 0; k < arms.length; k += PER_ARM) {
      const paint = colour(arms[k + 7]);
      const thick = 2 * arms[k + 6] * scale;
      const bare = thick < 5 * contour; // too thin for one
      if (bare && !inside) continue;
      ctx.strokeStyle = bare ? shaded(paint, 0.9) : inside ? paint : shaded(paint, 0.7);
      ctx.lineWidth = Math.max(thick - (inside && !bare ? 2 * contour : 0), 0.5 * pixelRatio);
      ctx.beginPath();
      ctx.moveTo(x(arms[k]), y(arms[k + 1]));
      ctx.lineTo(x(arms[k + 3]), y(arms[k + 4]));
      ctx.stroke();
    }
}

const PALE = "#dde3eb";
const QUIET = "#ccd5e0";

/** Of forces those from `look.least` on, in mean forces; `look.what` says whether clusters are coloured by their stress. */
export function drawPacking(canvas: HTMLCanvasElement, frame: NetworkFrame, size: number, look: Look): void {
  const { least } = look;
  const [x0, y0] = frame.lower;
  const [x1, y1] = frame.upper;
  const aspect = packingAspect(frame);
  const scale = size * pixelRatio * Math.min(1 / (x1 - x0), aspect / (y1 - y0));
  canvas.width = Math.round(size * pixelRatio);
  canvas.height = Math.round(size * pixelRatio * aspect);
  const ctx = canvas.getContext("2d")!;
  const left = (canvas.width - (x1 - x0) * scale) / 2;
  const top = (canvas.height - (y1 - y0) * scale) / 2;
  const [xs, ys] = frame.axes.map(words);
  const radius = words(frame.radius);
  const acrossAt: Place = (position) => left + (position - x0) * scale;
  const upAt: Place = (position) => canvas.height - top - (position - y0) * scale;
  const x = (node: number) => acrossAt(positionOf(frame, xs[node], 0));
  const y = (node: number) => upAt(positionOf(frame, ys[node], 1));
  const r = (node: number) => (radius[node] / 65535) * frame.radius_max * scale;

  const pairs = frame.nodes > 65535 ? longs(frame.pairs) : words(frame.pairs);
  const force = words(frame.force);
  const touched = new Uint8Array(frame.nodes);
  for (let c = 0; c < frame.contacts; ++c) {
    touched[pairs[2 * c]] += touched[pairs[2 * c]] < 2 ? 1 : 0;
    touched[pairs[2 * c + 1]] += touched[pairs[2 * c + 1]] < 2 ? 1 : 0;
  }

  const discs = (from: number, to: number, fill: string, stroke: string, wanted: (node: number) => boolean) => {
    ctx.beginPath();
    for (let node = from; node < to; ++node) {
      if (!wanted(node)) continue;
      ctx.moveTo(x(node) + r(node), y(node));
      ctx.arc(x(node), y(node), r(node), 0, 2 * Math.PI);
    }
    ctx.fillStyle = fill;
    ctx.fill();
    ctx.strokeStyle = stroke;
    ctx.lineWidth = Math.max(0.03 * scale, 0.35 * pixelRatio);
    ctx.stroke();
  };
  if (frame.clusters) {
    ctx.strokeStyle = "#aab4c2";
    ctx.lineWidth = 1.5 * pixelRatio;
    ctx.strokeRect(acrossAt(x0), upAt(y1), (x1 - x0) * scale, (y1 - y0) * scale);
    const stress = (i: number) => (i > 0 ? heat(i / STRONGEST_STRESS) : PALE);
    const quiet = (i: number) => (i > 0 ? QUIET : PALE);
    drawClusters(ctx, frame, scale, [acrossAt, upAt], look.what === "grains" ? stress : quiet);
    if (look.what === "grains") return;
  } else {
    discs(frame.grains, frame.grains + frame.beads, "#c3cad6", "#a9b2c0", () => true);
    discs(0, frame.grains, "#fbfcfd", "#d9dfe7", (node) => touched[node] < 2);
    discs(0, frame.grains, "#eceff4", "#c8d0db", (node) => touched[node] >= 2);
  }

  // Weak contacts first, so that strong ones lie on top; one path per class of force keeps it fast.
  const classes: number[][] = Array.from({ length: COLOURS }, () => []);
  for (let c = 0; c < frame.contacts; ++c) {
    const value = (force[c] / 65535) * frame.force_max;
    const k = Math.floor((Math.min(value, STRONGEST) / STRONGEST) * (COLOURS - 1) + 0.5);
    if (value > 0 && value >= least) classes[k].push(c);
  }
  ctx.lineCap = "round";
  classes.forEach((members, k) => {
    const value = (k / (COLOURS - 1)) * STRONGEST;
    ctx.strokeStyle = forceColour(value);
    ctx.lineWidth = Math.max(value * WIDTH * lineUnit(frame) * scale, 0.4 * pixelRatio);
    ctx.beginPath();
    for (const c of members) {
      ctx.moveTo(x(pairs[2 * c]), y(pairs[2 * c]));
      ctx.lineTo(x(pairs[2 * c + 1]), y(pairs[2 * c + 1]));
    }
    ctx.stroke();
  });
}

/** The scale of the colour of clusters: stresses from 0 to STRONGEST_STRESS. */
export function drawStressKey(canvas: HTMLCanvasElement, width: number, height: number): void {
  canvas.width = width * pixelRatio;
  canvas.height = height * pixelRatio;
  canvas.style.width = `${width}px`;
  canvas.style.height = `${height}px`;
  const ctx = canvas.getContext("2d")!;
  for (let px = 0; px < canvas.width; ++px) {
    ctx.fillStyle = heat(px / canvas.width);
    ctx.fillRect(px, 0, 1, canvas.height);
  }
}

/** The scale of width and colour: lines from 0 to STRONGEST mean forces. */
export function drawForceKey(canvas: HTMLCanvasElement, width: number, height: number): void {
  canvas.width = width * pixelRatio;
  canvas.height = height * pixelRatio;
  canvas.style.width = `${width}px`;
  canvas.style.height = `${height}px`;
  const ctx = canvas.getContext("2d")!;
  const thickest = 0.5 * canvas.height;
  for (let px = 0; px < canvas.width; ++px) {
    const value = (px / canvas.width) * STRONGEST;
    const thick = Math.max((value / STRONGEST) * thickest, pixelRatio);
    ctx.fillStyle = forceColour(value);
    ctx.fillRect(px, (canvas.height - thick) / 2, 1, thick);
  }
}
