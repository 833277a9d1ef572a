// Draws a persistence diagram: birth to the right, death upwards, so that all points lie under the diagonal; the longer
// a feature lives, the farther it is from it. Features that never die have a strip of their own below the axis.
import type { Bin, DiagramFrame } from "./data";
import { bytes, words } from "./packed";
import { pixelRatio } from "./pixel_ratio";
import { FONT, heat, INK, MUTED } from "./theme";

/** Borders of S1 Sec. II.C, in mean forces. */
const ROUGH = 0.1;
const WEAK = 0.1;
const MEDIUM = 1;
const STRONG = 2.5;

const BINS: { bin: Bin; from: number; to: number; fill: string }[] = [
  { bin: "weak", from: WEAK, to: MEDIUM, fill: "#f4f7fa" },
  { bin: "medium", from: MEDIUM, to: STRONG, fill: "#eaf0f6" },
  { bin: "strong", from: STRONG, to: Infinity, fill: "#dfe8f1" },
];

interface Points {
  birth: Float64Array;
  death: Float64Array;
  essential: Uint8Array;
}

function unpack(frame: DiagramFrame, dimension: number): Points {
  const packed = frame.dimensions[dimension];
  const values = words(packed.values);
  const birth = new Float64Array(packed.pairs);
  const death = new Float64Array(packed.pairs);
  for (let k = 0; k < packed.pairs; ++k) {
    birth[k] = (values[2 * k] / 65535) * frame.value_max;
    death[k] = (values[2 * k + 1] / 65535) * frame.value_max;
  }
  return { birth, death, essential: bytes(packed.essential) };
}

/** How many points lie near each point, by a smoothed count on a grid; 1 for the densest. */
function densities(points: Points, top: number): Float64Array {
  const cells = 72;
  const cell = (v: number) => Math.min(Math.max(Math.floor((v / top) * cells), 0), cells - 1);
  let grid = new Float64Array(cells * cells);
  for (let k = 0; k < points.birth.length; ++k) grid[cell(points.death[k]) * cells + cell(points.birth[k])] += 1;
  for (let pass = 0; pass < 2; ++pass) {
    const next = new Float64Array(cells * cells);
    for (let a = 0; a < cells; ++a)
      for (let b = 0; b < cells; ++b)
        for (let da = -1; da <= 1; ++da)
          for (let db = -1; db <= 1; ++db) {
            const i = a + da;
            const j = b + db;
            if (i < 0 || j < 0 || i >= cells || j >= cells) continue;
            next[a * cells + b] += (grid[i * cells + j] * (2 - Math.abs(da)) * (2 - Math.abs(db))) / 16;
          }
    grid = next;
  }
  const out = new Float64Array(points.birth.length);
  let most = 1e-9;
  for (let k = 0; k < out.length; ++k) {
    out[k] = grid[cell(points.death[k]) * cells + cell(points.birth[k])];
    most = Math.max(most, out[k]);
  }
  return out.map((v) => Math.log1p(v) / Math.log1p(most));
}

/** Upper end of the axes; points beyond it lie on its border. */
export const TOP = 5.15;

export function drawDiagram(
  canvas: HTMLCanvasElement,
  frame: DiagramFrame,
  dimension: number,
  size: number,
): void {
  canvas.width = canvas.height = Math.round(size * pixelRatio);
  const ctx = canvas.getContext("2d")!;
  const top = TOP;
  // Drawn in units that grow with the picture, so that an enlarged one reads as well from afar.
  const unit = Math.min(Math.max(size / 280, 1), 2);
  ctx.scale(pixelRatio * unit, pixelRatio * unit);
  size /= unit;
  const points = unpack(frame, dimension);
  const margin = { left: 30, right: 8, top: 8, bottom: 46 };
  const strip = 18;
  const width = size - margin.left - margin.right;
  const height = size - margin.top - margin.bottom;
  const x = (v: number) => margin.left + (Math.min(v, top) / top) * width;
  const y = (v: number) => margin.top + height - (Math.min(v, top) / top) * height;
  const stripTop = margin.top + height + 3;

  ctx.fillStyle = "#fff";
  ctx.fillRect(0, 0, size, size);
  const counts = frame.dimensions[dimension].bins; // counted by the program: values here are rounded for drawing
  for (const { from, to, fill } of BINS) {
    const right = Math.min(to, top);
    ctx.fillStyle = fill;
    ctx.beginPath();
    ctx.moveTo(x(from), y(0));
    ctx.lineTo(x(right), y(0));
    ctx.lineTo(x(right), y(right - ROUGH));
    ctx.lineTo(x(from), y(from - ROUGH));
    ctx.fill();
    ctx.fillRect(x(from), stripTop, x(right) - x(from), strip);
  }
  // The rough band along the diagonal.
  ctx.fillStyle = "#fdeccb";
  ctx.beginPath();
  ctx.moveTo(x(0), y(0));
  ctx.lineTo(x(ROUGH), y(0));
  ctx.lineTo(x(top), y(top - ROUGH));
  ctx.lineTo(x(top), y(top));
  ctx.fill();
  ctx.fillRect(x(0), stripTop, x(ROUGH) - x(0), strip);

  ctx.strokeStyle = "#9aa7b8";
  ctx.lineWidth = 1;
  for (const border of [WEAK, MEDIUM, STRONG]) {
    ctx.beginPath();
    ctx.moveTo(x(border), stripTop + strip);
    ctx.lineTo(x(border), stripTop);
    ctx.moveTo(x(border), y(0));
    ctx.lineTo(x(border), y(border - ROUGH));
    ctx.stroke();
  }
  ctx.beginPath();
  ctx.moveTo(x(ROUGH), y(0));
  ctx.lineTo(x(top), y(top - ROUGH));
  ctx.stroke();
  ctx.strokeStyle = INK;
  ctx.beginPath();
  ctx.moveTo(x(0), y(top));
  ctx.lineTo(x(0), y(0));
  ctx.lineTo(x(top), y(0));
  ctx.moveTo(x(0), y(0));
  ctx.lineTo(x(top), y(top));
  ctx.stroke();

  const density = densities(points, top);
  const order = Array.from(density.keys()).sort((a, b) => density[a] - density[b]);
  for (const k of order) {
    ctx.fillStyle = heat(0.3 + 0.7 * density[k]);
    if (points.essential[k]) {
      // Spread over the strip's height by a fixed rule, so that many equal births stay visible as a crowd.
      const spread = ((k * 0.618034) % 1) * (strip - 4);
      ctx.fillRect(x(points.birth[k]) - 0.8, stripTop + 2 + spread - 0.8, 1.8, 1.8);
    } else {
      ctx.beginPath();
      ctx.arc(x(points.birth[k]), y(points.death[k]), 1.5, 0, 2 * Math.PI);
      ctx.fill();
    }
  }

  ctx.fillStyle = MUTED;
  ctx.font = `11px ${FONT}`;
  ctx.textAlign = "center";
  ctx.textBaseline = "top";
  for (let v = 0; v < top; ++v) ctx.fillText(String(v), x(v), stripTop + strip + 4);
  ctx.textAlign = "right";
  ctx.textBaseline = "middle";
  for (let v = 1; v < top; ++v) ctx.fillText(String(v), margin.left - 5, y(v));
  ctx.fillText("∞", margin.left - 5, stripTop + strip / 2);
  ctx.textAlign = "center";
  ctx.fillText("birth", x(top / 2), stripTop + strip + 20);
  ctx.save();
  ctx.translate(8, y(top / 2));
  ctx.rotate(-Math.PI / 2);
  ctx.fillText("death", 0, 0);
  ctx.restore();

  // The bins' counts, above the diagonal where nothing else is.
  ctx.textAlign = "left";
  ctx.textBaseline = "top";
  const lines: [Bin, string][] = [
    ["strong", `strong ${counts.strong}`],
    ["medium", `medium ${counts.medium}`],
    ["weak", `weak ${counts.weak}`],
    ["rough", `rough ${counts.rough}`],
  ];
  ctx.fillStyle = INK;
  lines.forEach(([, text], k) => ctx.fillText(text, x(0) + 8, margin.top + 2 + 15 * k));
}
