// Curves with shaded error bands: uPlot, a tooltip, marks on the abscissa, and a cursor shared by charts of one key.
import uPlot from "uplot";
import "../uplot_notice";
import { h, markup } from "../dom";
import { INK } from "../theme";
import { abscissaRange, axes, linearRange, logRange } from "./axes";
import { joined, seriesIndices, seriesOf } from "./columns";
import { markers, notes } from "./markers";
import type { ChartOptions, Line } from "./options";
import { decoration, dotIndex, hollowPoints, tooltip } from "./overlay";

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
