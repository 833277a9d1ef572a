// What is drawn on and over curves: marks, hollow points, the read-out under the cursor.
import type uPlot from "uplot";
import type { ChartOptions, Line } from "./options";
import { meanIndex } from "./columns";
import { h } from "../dom";
import { plain, withError } from "../numbers";
import { faded, FONT, MUTED } from "../theme";

/** Draws marks and the level under the curves. */
export function decoration(options: ChartOptions): uPlot.Plugin {
  return {
    hooks: {
      drawAxes: (u: uPlot) => {
        const { ctx } = u;
        const { left, top, width, height } = u.bbox;
        const ratio = globalThis.chartPixelRatio;
        ctx.save();
        ctx.beginPath();
        ctx.rect(left, top, width, height);
        ctx.clip();
        if (options.level !== undefined) {
          const y = u.valToPos(options.level, "y", true);
          ctx.strokeStyle = "#98a2b3";
          ctx.lineWidth = ratio;
          ctx.beginPath();
          ctx.moveTo(left, y);
          ctx.lineTo(left + width, y);
          ctx.stroke();
        }
        for (const mark of options.marks ?? []) {
          if (mark.system !== undefined && options.shown && !options.shown(mark.system)) continue;
          const x = u.valToPos(mark.x, "x", true);
          if (mark.kind === "line") {
            ctx.strokeStyle = faded(mark.colour, 0.75);
            ctx.lineWidth = 1.2 * ratio;
            ctx.setLineDash([5 * ratio, 4 * ratio]);
            ctx.beginPath();
            ctx.moveTo(x, top);
            ctx.lineTo(x, top + height);
            ctx.stroke();
            ctx.setLineDash([]);
            if (mark.label) {
              ctx.fillStyle = MUTED;
              ctx.textAlign = "left";
              ctx.textBaseline = "alphabetic";
              ctx.font = `${11 * ratio}px ${FONT}`;
              ctx.fillText(mark.label, x + 4 * ratio, top + 12 * ratio);
            }
          }
          const size = 5 * ratio;
          ctx.fillStyle = mark.colour;
          ctx.beginPath();
          ctx.moveTo(x, top + height - 1.6 * size);
          ctx.lineTo(x - 0.8 * size, top + height);
          ctx.lineTo(x + 0.8 * size, top + height);
          ctx.fill();
        }
        ctx.restore();
      },
    },
  };
}

/** Hollow points where a realisation was not relaxed, crosses at the foot where its energy ledger is off. */
export function hollowPoints(lines: () => Line[]): uPlot.Plugin {
  return {
    hooks: {
      draw: (u: uPlot) => {
        const { ctx } = u;
        const ratio = globalThis.chartPixelRatio;
        const { left, top, width, height } = u.bbox;
        ctx.save();
        ctx.beginPath();
        ctx.rect(left - 4 * ratio, top - 4 * ratio, width + 8 * ratio, height + 8 * ratio);
        ctx.clip();
        lines().forEach((line, k) => {
          if (!u.series[meanIndex(k)].show) return;
          line.unrelaxed?.forEach((count, point) => {
            const value = line.y[point];
            if (!count || value === null) return;
            ctx.beginPath();
            ctx.arc(u.valToPos(line.x[point], "x", true), u.valToPos(value, "y", true), 3.4 * ratio, 0, 2 * Math.PI);
            ctx.fillStyle = "#fff";
            ctx.fill();
            ctx.strokeStyle = line.colour;
            ctx.lineWidth = 1.5 * ratio;
            ctx.stroke();
          });
          const foot = top + height - 5 * ratio;
          line.marked?.forEach((count, point) => {
            if (!count) return;
            const x = u.valToPos(line.x[point], "x", true);
            const arm = 3 * ratio;
            ctx.beginPath();
            ctx.moveTo(x - arm, foot - arm);
            ctx.lineTo(x + arm, foot + arm);
            ctx.moveTo(x - arm, foot + arm);
            ctx.lineTo(x + arm, foot - arm);
            ctx.strokeStyle = line.colour;
            ctx.lineWidth = 1.5 * ratio;
            ctx.stroke();
          });
        });
        ctx.restore();
      },
    },
  };
}

/** Index of the line's own point nearest to x; null farther than half a step beyond its ends. */
function nearestPoint(line: Line, x: number): number | null {
  const last = line.x.length - 1;
  if (last < 0) return null;
  const half = last > 0 ? (line.x[last] - line.x[0]) / last / 2 : Infinity;
  if (x < line.x[0] - half || x > line.x[last] + half) return null;
  let best = 0;
  for (let k = 1; k <= last; ++k) if (Math.abs(line.x[k] - x) < Math.abs(line.x[best] - x)) best = k;
  return best;
}

/** Where the dot of a curve stands under the cursor: at its own point nearest to it. */
export function dotIndex(u: uPlot, series: number, hovered: number): number {
  const column = u.data[series];
  for (let away = 0; away < 20; ++away) {
    if (column[hovered - away] != null) return hovered - away;
    if (column[hovered + away] != null) return hovered + away;
  }
  return hovered;
}

export function tooltip(options: ChartOptions, lines: () => Line[]): uPlot.Plugin {
  const box = h("div", "tooltip");
  let inside = false;
  const show = (u: uPlot) => {
    const { left, idx } = u.cursor;
    const rows: string[] = [];
    if (inside && idx != null && left != null && left >= 0) {
      lines().forEach((line, k) => {
        const at = u.series[meanIndex(k)].show ? nearestPoint(line, u.data[0][idx]) : null;
        const value = at === null ? null : line.y[at];
        if (at === null || value === null) return;
        const count = line.unrelaxed?.[at];
        const marked = line.marked?.[at];
        rows.push(
          `<tr><td><i class="swatch" style="background:${line.colour}"></i></td><td>${line.label}` +
            `${count ? ` <span class="what">${count} not relaxed</span>` : ""}` +
            `${marked ? ` <span class="what">${marked} with the ledger off</span>` : ""}</td>` +
            `<td>${withError(value, line.se?.[at] ?? null)}</td></tr>`,
        );
      });
    }
    box.hidden = rows.length === 0;
    if (box.hidden) return;
    box.innerHTML = `<b>${options.xName} = ${plain(u.data[0][idx!])}</b><table>${rows.join("")}</table>`;
    const right = left! > u.over.clientWidth / 2;
    box.style.left = right ? "" : `${left! + 14}px`;
    box.style.right = right ? `${u.over.clientWidth - left! + 14}px` : "";
  };
  return {
    hooks: {
      init: (u: uPlot) => {
        box.hidden = true;
        u.over.append(box);
        u.over.addEventListener("mouseenter", () => (inside = true));
        u.over.addEventListener("mouseleave", () => {
          inside = false;
          box.hidden = true;
        });
      },
      setCursor: show,
    },
  };
}
