// Points of chosen forms with bars for their errors, and marks at the foot of shifted lines.
import type uPlot from "uplot";
import type { Line } from "./options";
import { meanIndex } from "./columns";
import { FONT } from "../theme";

/** Calls `paint` with the context clipped to the panel, `border` pixels of the page around it left open. */
function clipped(u: uPlot, border: number, paint: (ctx: CanvasRenderingContext2D, ratio: number) => void): void {
  const { ctx } = u;
  const ratio = globalThis.chartPixelRatio;
  const { left, top, width, height } = u.bbox;
  const room = border * ratio;
  ctx.save();
  ctx.beginPath();
  ctx.rect(left - room, top - room, width + 2 * room, height + 2 * room);
  ctx.clip();
  paint(ctx, ratio);
  ctx.restore();
}

function outlineOf(ctx: CanvasRenderingContext2D, form: NonNullable<Line["marker"]>, x: number, y: number, r: number): void {
  ctx.beginPath();
  if (form === "disc") ctx.arc(x, y, r, 0, 2 * Math.PI);
  else {
    const corners: Record<string, [number, number][]> = {
      square: [[-0.9, -0.9], [0.9, -0.9], [0.9, 0.9], [-0.9, 0.9]],
      diamond: [[0, -1.25], [1.25, 0], [0, 1.25], [-1.25, 0]],
      triangle: [[0, -1.2], [1.1, 0.85], [-1.1, 0.85]],
    };
    for (const [dx, dy] of corners[form]) ctx.lineTo(x + r * dx, y + r * dy);
    ctx.closePath();
  }
}

/** Published values (no line between them) are hollow. */
export function markers(lines: () => Line[]): uPlot.Plugin {
  const draw = (u: uPlot) =>
    clipped(u, 5, (ctx, ratio) =>
      lines().forEach((line, k) => {
        if (!line.marker || !u.series[meanIndex(k)].show) return;
        ctx.strokeStyle = line.colour;
        ctx.lineWidth = 1.4 * ratio;
        line.x.forEach((abscissa, point) => {
          const value = line.y[point];
          if (value === null) return;
          const x = u.valToPos(abscissa, "x", true);
          const se = line.bars ? line.se?.[point] : null;
          if (se) {
            const [low, high] = [value - se, value + se].map((v) => u.valToPos(v, "y", true));
            ctx.beginPath();
            ctx.moveTo(x, low);
            ctx.lineTo(x, high);
            for (const end of [low, high]) {
              ctx.moveTo(x - 3 * ratio, end);
              ctx.lineTo(x + 3 * ratio, end);
            }
            ctx.stroke();
          }
          outlineOf(ctx, line.marker!, x, u.valToPos(value, "y", true), 4 * ratio);
          ctx.fillStyle = line.joined ? line.colour : "#fff";
          ctx.fill();
          ctx.stroke();
        });
      }),
    );
  return { hooks: { draw } };
}

/** A foot line under each shifted curve, with triangles and names where something is expected. */
export function notes(lines: () => Line[]): uPlot.Plugin {
  const draw = (u: uPlot) =>
    clipped(u, 0, (ctx, ratio) => {
      ctx.font = `${10.5 * ratio}px ${FONT}`;
      ctx.textAlign = "left";
      ctx.textBaseline = "alphabetic";
      lines().forEach((line, k) => {
        if (line.shift === undefined || !u.series[meanIndex(k)].show) return;
        const y = u.valToPos(line.shift, "y", true);
        ctx.strokeStyle = "#d5dbe3";
        ctx.lineWidth = ratio;
        ctx.beginPath();
        ctx.moveTo(u.bbox.left, y);
        ctx.lineTo(u.bbox.left + u.bbox.width, y);
        ctx.stroke();
        ctx.fillStyle = line.colour;
        const places = (line.notes ?? []).map((note) => u.valToPos(note.x, "x", true));
        (line.notes ?? []).forEach(({ text }, n) => {
          const x = places[n];
          // Of two that stand close together the left one has its name on its left.
          const crowded = places.some((other) => other > x && other - x < 24 * ratio);
          ctx.textAlign = crowded ? "right" : "left";
          ctx.beginPath();
          ctx.moveTo(x, y - 7 * ratio);
          ctx.lineTo(x - 3.5 * ratio, y);
          ctx.lineTo(x + 3.5 * ratio, y);
          ctx.fill();
          ctx.fillText(text, x + (crowded ? -5 : 5) * ratio, y - 2 * ratio);
        });
      });
    });
  return { hooks: { drawAxes: draw } };
}
