// Histograms with many narrow bins, made readable.

export interface Binned {
  x: number[];
  mean: (number | null)[];
  se: (number | null)[];
}

/** Edges of bins from their centres, which are spaced evenly or by a factor. */
function edges(x: number[]): number[] {
  const step = x.length > 1 ? x[1] - x[0] : 1;
  if (x.length > 2 && Math.abs(x[2] - x[1] - step) < 1e-3 * step) return [x[0] - step / 2, ...x.map((v) => v + step / 2)];
  const ratio = x.length > 1 ? Math.sqrt(x[1] / x[0]) : 1;
  return [x[0] / ratio, ...x.map((v) => v * ratio)];
}

/**
 * Joins neighbouring bins of a density until each is `width` wide and holds `least` counts; their standard errors are
 * taken as independent. What is left at the end joins the last bin.
 */
export function joinBins(bins: Binned, counts: (number | null)[], width: number, least: number): Binned {
  if (bins.x.length < 2) return bins;
  const edge = edges(bins.x);
  const groups: [number, number][] = [];
  let start = 0;
  let held = 0;
  for (let k = 0; k < bins.x.length; ++k) {
    held += counts[k] ?? 0;
    if (edge[k + 1] - edge[start] < width || held < least) continue;
    groups.push([start, k]);
    start = k + 1;
    held = 0;
  }
  if (held > 0 && groups.length) groups[groups.length - 1][1] = lastHeld(counts);
  const out: Binned = { x: [], mean: [], se: [] };
  for (const [first, last] of groups) {
    const whole = edge[last + 1] - edge[first];
    let content = 0;
    let variance: number | null = 0;
    for (let b = first; b <= last; ++b) {
      const part = edge[b + 1] - edge[b];
      content += part * (bins.mean[b] ?? 0);
      const se = bins.se[b];
      variance = se === null || variance === null ? null : variance + (part * se) ** 2;
    }
    out.x.push(0.5 * (edge[first] + edge[last + 1]));
    out.mean.push(content / whole);
    out.se.push(variance === null ? null : Math.sqrt(variance) / whole);
  }
  return out;
}

function lastHeld(counts: (number | null)[]): number {
  let k = counts.length - 1;
  while (k > 0 && !counts[k]) k -= 1;
  return k;
}
