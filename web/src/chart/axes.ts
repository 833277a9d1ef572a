// Axes and ranges of curves.
import type uPlot from "uplot";
import type { ChartOptions } from "./options";
import { plain, superscript } from "../numbers";
import { FONT, GRID, MUTED } from "../theme";

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

export function axes(options: ChartOptions): uPlot.Axis[] {
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
  const { ticks } = options;
  const named = ticks && {
    splits: () => ticks.map((tick) => tick.at),
    values: (_: uPlot, splits: number[]) => splits.map((at) => ticks.find((tick) => tick.at === at)?.text ?? ""),
    grid: { show: false },
    space: 5,
  };
  return [
    { ...common, size: 30, space: 55, values: (_, splits) => splits.map((v) => plain(v)) },
    {
      ...common,
      ...(options.log ? { splits: logSplits, grid: { ...common.grid, filter: onlyDecades as uPlot.Axis.Filter } } : {}),
      size: (_, values) => Math.max(46, 15 + 7 * Math.max(0, ...(values ?? []).map((text) => text.length))),
      space: options.log ? 14 : 36,
      values: options.log ? decades : (_, splits) => splits.map((v) => (v === null ? "" : plain(v))),
      ...named,
    },
  ];
}

/** The range asked for until the reader zooms in. */
export function abscissaRange(options: ChartOptions): uPlot.Scale.Range {
  return (u, low, high) => {
    const xs = u.data[0];
    const whole = low === xs[0] && high === xs[xs.length - 1];
    return whole && options.xRange ? options.xRange : [low, high];
  };
}

export function linearRange(options: ChartOptions): uPlot.Scale.Range {
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

export function logRange(options: ChartOptions): uPlot.Scale.Range {
  return (_, low, high) => {
    if (options.yRange) return options.yRange;
    if (low === null || high === null || !(low > 0)) return [0.1, 1];
    return [Math.max(low / 1.3, high / DECADES), high * 1.3];
  };
}
