// Curves with shaded error bands: uPlot, a tooltip, marks on the abscissa, and a cursor shared by charts of one key.
import uPlot from "uplot";
import "../uplot_notice";
import { h, markup } from "../dom";
import { INK } from "../theme";
import { abscissaRange, axes, linearRange, logRange } from "./axes";
import { joined, seriesIndices, seriesOf } from "./columns";
import { markers, notes } from "./markers";
import { decoration, dotIndex, hollowPoints, tooltip } from "./overlay";

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
  /** points of this form, and no line between them unless `joined` */
  marker?: "disc" | "square" | "triangle" | "diamond";
  joined?: boolean;
  /** errors as bars at the points, in place of a band */
  bars?: boolean;
  /** drawn so much higher than it is */
  shift?: number;
  /** marks at the foot of a shifted line */
  notes?: { x: number; text: string }[];
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
  label?: string;
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
  /** in place of the numbers of the ordinate */
  ticks?: { at: number; text: string }[];
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
        for (const index of seriesIndices(k)) plotted.setSeries(index, { show: isShown(line) }, false);
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
        plugins: [
          decoration(options),
          notes(() => lines),
          markers(() => lines),
          hollowPoints(() => lines),
          tooltip(options, () => lines),
        ],
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
