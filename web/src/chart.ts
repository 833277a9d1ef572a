// Curves with shaded error bands: uPlot, a tooltip, marks on the abscissa, and a cursor shared by charts of one key.
import uPlot from "uplot";
import "./uplot_notice";
import { h, markup } from "./dom";
import { plain, superscript, withError } from "./numbers";
import { faded, FONT, GRID, INK, MUTED } from "./theme";

export interface Line {
  /** markup, for the tooltip */
  label: string;
  colour: string;
  dash?: number[];
  width?: number;
  /** opacity of the error band */
  band?: number;
  /** false: no dots even where the points are few */
  points?: boolean;
  /** index of the system this line belongs to, when the legend may hide it */
  system?: number;
  x: number[];
  y: (number | null)[];
  se?: (number | null)[];
  /** per point, how many realisations were not relaxed; such points are hollow */
  unrelaxed?: number[];
}

export interface Mark {
  x: number;
  colour: string;
  system?: number;
  /** "line" over the whole height, or a "tick" on the axis */
  kind: "line" | "tick";
}

export interface ChartOptions {
  /** markup */
  title: string;
  xLabel: string;
  /** what x is called in the tooltip */
  xName: string;
  lines: Line[];
  marks?: Mark[];
  height?: number;
  log?: boolean;
  /** the ordinate starts at zero */
  zero?: boolean;
  xRange?: [number, number];
  yRange?: [number, number];
  /** a horizontal line worth seeing */
  level?: number;
  sync?: string;
  shown?: (system: number) => boolean;
}

export interface Chart {
  element: HTMLElement;
  /** Shows and hides lines after the legend changed. */
  refresh(): void;
  /** Other lines in the same frame; as many as before, in the same order. */
  replace(lines: Line[]): void;
}

const SERIES_PER_LINE = 3; // mean, lower, upper
const meanIndex = (line: number) => 1 + SERIES_PER_LINE * line;

type Column = (number | null | undefined)[];

/**
 * All lines on the union of their abscissae: undefined where a line has no point, null where its point has no value, which
 * leaves a gap. On a logarithmic axis with a fixed range a
 * zero becomes `floor`, far below the axis, so that the curve leaves the panel; without one it is left out.
 */
function joined(lines: Line[], log: boolean, floor: number): uPlot.AlignedData {
  const xs = [...new Set(lines.flatMap((line) => line.x))].sort((a, b) => a - b);
  const place = new Map(xs.map((x, k) => [x, k]));
  const columns: Column[] = [];
  for (const line of lines) {
    const mean: Column = new Array(xs.length).fill(undefined);
    const lower = [...mean];
    const upper = [...mean];
    line.x.forEach((x, k) => {
      const known = line.y[k];
      const at = place.get(x)!;
      if (known === null) {
        mean[at] = lower[at] = upper[at] = null;
        return;
      }
      if (log && known <= 0 && floor === 0) return;
      const value = log ? Math.max(known, floor) : known;
      const se = line.se?.[k] ?? 0;
      mean[at] = value;
      lower[at] = log ? Math.max(value - se, value / 20) : value - se;
      upper[at] = value + se;
    });
    columns.push(mean, lower, upper);
  }
  return [xs, ...columns] as unknown as uPlot.AlignedData;
}

function seriesOf(lines: Line[]): { series: uPlot.Series[]; bands: uPlot.Band[] } {
  const series: uPlot.Series[] = [{}];
  const bands: uPlot.Band[] = [];
  lines.forEach((line, k) => {
    const edge: uPlot.Series = { stroke: "transparent", width: 0, points: { show: false } };
    const sparse = line.points !== false && line.x.length < 30;
    series.push(
      {
        stroke: line.colour,
        width: line.width ?? 2,
        dash: line.dash,
        points: { show: sparse, size: 4.5, fill: line.colour, stroke: line.colour },
      },
      { ...edge },
      { ...edge },
    );
    bands.push({ series: [meanIndex(k) + 2, meanIndex(k) + 1], fill: faded(line.colour, line.band ?? 0.2) });
  });
  return { series, bands };
}

/** One to nine times the powers of ten in the range; uPlot's own search for them needs a range that starts at one. */
function logSplits(_: uPlot, __: number, low: number, high: number): number[] {
  const splits: number[] = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); ++power)
    for (let k = 1; k < 10; ++k) {
      const value = k * 10 ** power;
      if (value >= low && value <= high) splits.push(value);
    }
  return splits;
}

function axes(options: ChartOptions): uPlot.Axis[] {
  const common: uPlot.Axis = {
    stroke: MUTED,
    font: `12px ${FONT}`,
    grid: { stroke: GRID, width: 1 },
    ticks: { stroke: "#cfd5de", width: 1, size: 5 },
  };
  const isDecade = (v: number) => Math.abs(Math.log10(v) - Math.round(Math.log10(v))) < 1e-6;
  const onlyDecades = (_: uPlot, splits: number[]) => splits.map((v) => (isDecade(v) ? v : null));
  const decades = (_: uPlot, splits: (number | null)[]) =>
    splits.map((v) => {
      if (v === null || !isDecade(v)) return "";
      const power = Math.log10(v);
      const exponent = Math.round(power);
      return exponent === 0 ? "1" : exponent === 1 ? "10" : `10${superscript(exponent)}`;
    });
  return [
    { ...common, size: 30, space: 55, values: (_, splits) => splits.map((v) => plain(v)) },
    {
      ...common,
      ...(options.log ? { splits: logSplits, grid: { ...common.grid, filter: onlyDecades as uPlot.Axis.Filter } } : {}),
      size: (_, values) => Math.max(46, 15 + 7 * Math.max(0, ...(values ?? []).map((text) => text.length))),
      space: options.log ? 14 : 36,
      values: options.log ? decades : (_, splits) => splits.map((v) => (v === null ? "" : plain(v))),
    },
  ];
}

/** The range asked for until the reader zooms in. */
function abscissaRange(options: ChartOptions): uPlot.Scale.Range {
  return (u, low, high) => {
    const xs = u.data[0];
    const whole = low === xs[0] && high === xs[xs.length - 1];
    return whole && options.xRange ? options.xRange : [low, high];
  };
}

function linearRange(options: ChartOptions): uPlot.Scale.Range {
  return (_, low, high) => {
    if (options.yRange) return options.yRange;
    if (low === null || high === null || !Number.isFinite(low)) return [0, 1];
    if (options.level !== undefined) {
      low = Math.min(low, options.level);
      high = Math.max(high, options.level);
    }
    const pad = 0.06 * (high - low || Math.abs(high) || 1);
    if (options.zero && low >= 0) return [0, high + pad];
    return [low - pad, high + pad];
  };
}

/** No more than eight decades are shown; curves below leave the panel. */
const DECADES = 1e8;

function logRange(options: ChartOptions): uPlot.Scale.Range {
  return (_, low, high) => {
    if (options.yRange) return options.yRange;
    if (low === null || high === null || !(low > 0)) return [0.1, 1];
    return [Math.max(low / 1.3, high / DECADES), high * 1.3];
  };
}

/** Draws marks and the level under the curves. */
function decoration(options: ChartOptions): uPlot.Plugin {
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

/** Hollow points where a realisation was not relaxed. */
function hollowPoints(lines: () => Line[]): uPlot.Plugin {
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
function dotIndex(u: uPlot, series: number, hovered: number): number {
  const column = u.data[series];
  for (let away = 0; away < 20; ++away) {
    if (column[hovered - away] != null) return hovered - away;
    if (column[hovered + away] != null) return hovered + away;
  }
  return hovered;
}

function tooltip(options: ChartOptions, lines: () => Line[]): uPlot.Plugin {
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
        rows.push(
          `<tr><td><i class="swatch" style="background:${line.colour}"></i></td><td>${line.label}` +
            `${count ? ` <span class="what">${count} not relaxed</span>` : ""}</td>` +
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

export function chart(options: ChartOptions): Chart {
  let lines = options.lines;
  const plot = h("div", "plot");
  const element = h(
    "div",
    "chart",
    markup(options.title, "div", "chart-title"),
    plot,
    markup(options.xLabel, "div", "chart-x"),
  );
  const isShown = (line: Line) => line.system === undefined || !options.shown || options.shown(line.system);
  const height = options.height ?? 240;
  const floor = options.log && options.yRange ? options.yRange[0] / 1e3 : 0;
  const { series, bands } = seriesOf(lines);
  let u: uPlot | null = null;

  const refresh = () => {
    if (!u) return;
    const plotted = u;
    plotted.batch(() =>
      lines.forEach((line, k) => {
        for (let part = 0; part < SERIES_PER_LINE; ++part)
          plotted.setSeries(meanIndex(k) + part, { show: isShown(line) }, false);
      }),
    );
  };

  const draw = (width: number) => {
    if (u) {
      u.setSize({ width, height });
      return;
    }
    u = new uPlot(
      {
        width,
        height,
        padding: [10, 12, 0, 0],
        scales: {
          x: { time: false, range: abscissaRange(options) },
          y: options.log ? { distr: 3, range: logRange(options) } : { range: linearRange(options) },
        },
        series,
        bands,
        axes: axes(options),
        legend: { show: false },
        cursor: {
          y: false,
          dataIdx: dotIndex,
          points: { size: 7, width: 1.5, fill: "#fff" },
          sync: options.sync ? { key: options.sync, setSeries: false } : undefined,
        },
        plugins: [decoration(options), hollowPoints(() => lines), tooltip(options, () => lines)],
      },
      joined(lines, options.log ?? false, floor),
      plot,
    );
    u.root.style.color = INK;
    refresh();
  };

  new ResizeObserver(([entry]) => {
    const width = Math.floor(entry.contentRect.width);
    if (width > 40) requestAnimationFrame(() => draw(width));
  }).observe(plot);

  return {
    element,
    refresh,
    replace(next) {
      lines = next;
      u?.setData(joined(next, options.log ?? false, floor));
    },
  };
}
