// Lines as uPlot wants them: one column of abscissae, and three of values per line.
import type uPlot from "uplot";
import type { Line } from "./options";
import { faded } from "../theme";

const SERIES_PER_LINE = 3; // mean, lower, upper
export const meanIndex = (line: number) => 1 + SERIES_PER_LINE * line;
/** Indices of the series of a line. */
export const seriesIndices = (line: number) => [0, 1, 2].map((part) => meanIndex(line) + part);

type Column = (number | null | undefined)[];

/**
 * All lines on the union of their abscissae: undefined where a line has no point, null where its point has no value, which
 * leaves a gap. On a logarithmic axis with a fixed range a
 * zero becomes `floor`, far below the axis, so that the curve leaves the panel; without one it is left out.
 */
export function joined(lines: Line[], log: boolean, floor: number): uPlot.AlignedData {
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
      const value = (log ? Math.max(known, floor) : known) + (line.shift ?? 0);
      const se = line.se?.[k] ?? 0;
      mean[at] = value;
      lower[at] = log ? Math.max(value - se, value / 20) : value - se;
      upper[at] = value + se;
    });
    columns.push(mean, lower, upper);
  }
  return [xs, ...columns] as unknown as uPlot.AlignedData;
}

export function seriesOf(lines: Line[]): { series: uPlot.Series[]; bands: uPlot.Band[] } {
  const series: uPlot.Series[] = [{}];
  const bands: uPlot.Band[] = [];
  lines.forEach((line, k) => {
    const edge: uPlot.Series = { stroke: "transparent", width: 0, points: { show: false } };
    const sparse = !line.marker && line.points !== false && line.x.length < 30;
    const stroke = line.marker && !line.joined ? "transparent" : line.colour;
    series.push(
      {
        stroke,
        width: line.width ?? 2,
        dash: line.dash,
        points: { show: sparse, size: 4.5, fill: line.colour, stroke: line.colour },
      },
      { ...edge },
      { ...edge },
    );
    bands.push({ series: [meanIndex(k) + 2, meanIndex(k) + 1], fill: line.bars ? "transparent" : faded(line.colour, line.band ?? 0.2) });
  });
  return { series, bands };
}
