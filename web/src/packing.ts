// Draws one packing with its force network: grains as discs, contacts as lines whose width and colour follow the force.
import type { NetworkFrame } from "./data";
import { longs, words } from "./packed";
import { pixelRatio } from "./pixel_ratio";
import { heat } from "./theme";

/** Forces above this many mean forces are drawn alike (S1 clamps there too). */
export const STRONGEST = 5;
/** Line width per mean force, in units of the mean grain diameter. */
const WIDTH = 0.15;

const COLOURS = 32;

export function forceColour(force: number): string {
  return heat(force / 4);
}

/** Forces below `least`, in mean forces, are left out. */
export function drawPacking(canvas: HTMLCanvasElement, frame: NetworkFrame, size: number, least = 0): void {
  const [x0, y0] = frame.lower;
  const [x1, y1] = frame.upper;
  const scale = (size * pixelRatio) / Math.max(x1 - x0, y1 - y0);
  canvas.width = canvas.height = Math.round(size * pixelRatio);
  const ctx = canvas.getContext("2d")!;
  const left = (canvas.width - (x1 - x0) * scale) / 2;
  const top = (canvas.height - (y1 - y0) * scale) / 2;
  const [xs, ys] = frame.axes.map(words);
  const radius = words(frame.radius);
  const from = (word: number, side: number) => (word / 65535) * (side + 2 * frame.margin) - frame.margin;
  const x = (node: number) => left + from(xs[node], x1 - x0) * scale;
  const y = (node: number) => canvas.height - top - from(ys[node], y1 - y0) * scale;
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
  discs(frame.grains, frame.grains + frame.beads, "#c3cad6", "#a9b2c0", () => true);
  discs(0, frame.grains, "#fbfcfd", "#d9dfe7", (node) => touched[node] < 2);
  discs(0, frame.grains, "#eceff4", "#c8d0db", (node) => touched[node] >= 2);

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
    ctx.lineWidth = Math.max(value * WIDTH * scale, 0.4 * pixelRatio);
    ctx.beginPath();
    for (const c of members) {
      ctx.moveTo(x(pairs[2 * c]), y(pairs[2 * c]));
      ctx.lineTo(x(pairs[2 * c + 1]), y(pairs[2 * c + 1]));
    }
    ctx.stroke();
  });
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
