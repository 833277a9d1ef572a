// Where the neighbours of a cluster are: radial distributions, and their peaks beside the distances of closest configurations.
import type { Line } from "../chart/options";
import type { Context, Section } from "../context";
import { finalValue, shapeOf, type FinalDistribution, type ShapeFacts } from "../data";
import { figure, h, table } from "../dom";
import { containersOf, curveLabel, panelDash, type Kind } from "../kinds";
import { plain, withError } from "../numbers";
import { dashKey } from "../over_sphericity";

/** Curves of one kind are shifted by this, as in S3. */
const SHIFT = 2;

interface Distance {
  name: string;
  at: number;
}

/** The distances that mean something for a shape, in L. */
function distancesOf(shape: ShapeFacts): Distance[] {
  const named: [string, number | null][] =
    shape.name === "cross"
      ? [
          ["D₁", shape.d1],
          ["D₂", shape.d2],
          ["D₃", shape.d3],
        ]
      : shape.name === "star"
        ? [
            ["J₁", shape.j1],
            ["D₁", shape.d1],
          ]
        : [];
  return named.flatMap(([name, at]) => (at === null ? [] : [{ name, at }]));
}

/** Curves from long arms (below) to round grains; the step between them fits the highest peak of each. */
function curvesOf(context: Context, data: FinalDistribution, kind: Kind): Line[] {
  const lines: Line[] = [];
  let base = 0;
  for (const k of [...kind.systems].reverse()) {
    const frame = data.systems[k].frames[0];
    const g = frame?.quantities.g_pooled ?? frame?.quantities.g;
    if (!g?.mean.some((v) => v !== null)) continue;
    const shape = shapeOf(context.data, k)!;
    lines.push({
      ...context.line(k, frame.x, g),
      label: curveLabel(context.data, k),
      dash: panelDash(context.data, k),
      width: 1.5,
      points: false,
      shift: base,
      notes: distancesOf(shape).map(({ name, at }) => ({ x: at, text: name })),
    });
    const highest = g.mean.reduce<number>((most, v) => Math.max(most, v ?? 0), 0);
    base += Math.max(SHIFT, Math.ceil(highest + 0.3));
  }
  return lines;
}

export const radial: Section = {
  id: "radial",
  title: "Neighbours",
  build(context) {
    const data = context.data.finalDistribution("radial_distribution");
    const kinds = containersOf(context.data);
    if (!data || !kinds.length) return null;
    const panels = kinds.flatMap((kind) => {
      const lines = curvesOf(context, data, kind);
      if (!lines.length) return [];
      const top = lines[lines.length - 1];
      const highest = top.y.reduce<number>((most, v) => Math.max(most, v ?? 0), 0) + top.shift!;
      const made = context.chart({
        title: `${kind.label} <span class="what"><i>G</i>(<i>r</i>), shifted</span>`,
        xLabel: "distance <i>r</i>/<i>L</i>",
        xName: "<i>r</i>/<i>L</i>",
        lines,
        height: Math.min(180 + 62 * lines.length, 620),
        xRange: [0, 4],
        yRange: [0, 1.04 * highest],
        ticks: lines.flatMap(({ shift }) => [0, 1].map((g) => ({ at: shift! + g, text: String(g) }))),
        sync: "radial",
      });
      return [made.element];
    });
    if (!panels.length) return null;
    const curves = figure("", [h("div", panels.length > 1 ? "grid two" : "", ...panels), ...dashKey(context)], {
        text:
          "How many grains lie at a distance from a grain, against a random arrangement of the same density; one curve per shape, " +
          "shifted upwards from long arms (below) to round grains. Marks under a curve are distances of the closest configurations " +
          "of its shape: <i>D</i><sub>1</sub> to <i>D</i><sub>3</sub> of crosses in each other's corners, <i>J</i><sub>1</sub> of nested " +
          "stars. Only grains away from the walls are references.",
        formula: "<i>G</i>(<i>r</i>) = pairs / (4π<i>r</i><sup>2</sup> Δ<i>r N</i><sub>ref</sub> <i>ρ<sub>N</sub></i>); 2π<i>r</i> in two dimensions",
      source: "S3 Eqs. 9 to 12, Fig. 7.",
    });
    const peaks = peaksTable(context, kinds);
    return peaks ? [curves, peaks] : [curves];
  },
};

/** Positions found, calculated and printed. */
function peaksTable(context: Context, kinds: Kind[]): HTMLElement | null {
  const { conzelmann } = context.data;
  const rows = kinds.flatMap((kind) =>
    kind.systems.flatMap((k) => {
      const peak = (n: number) => finalValue(context.data, k, `rdf_peak${n}`);
      if (![1, 2, 3].some((n) => peak(n))) return [];
      const shape = shapeOf(context.data, k)!;
      const alike = (dimension: number, psi: number) =>
        dimension === kind.dimension && (kind.dimension === 2 || kind.walls === "cylinder") && Math.abs(psi - shape.sphericity) < 0.006;
      const printed = conzelmann?.peaks.find((row) => alike(row.dimension, row.sphericity));
      const cells = [1, 2, 3].flatMap((n) => {
        const found = peak(n);
        const inner = finalValue(context.data, k, `rdf_peak${n}_error`)?.mean ?? null;
        const calculated = kind.dimension === 2 ? [shape.d1, shape.d2, shape.d3][n - 1] : n === 1 ? shape.j1 : null;
        const known = printed ? printed.peaks[n - 1] : undefined;
        return [
          found ? `<b>${withError(found.mean, found.se ?? inner)}</b>` : "–",
          calculated === null ? "–" : plain(calculated, 3),
          known === undefined ? "–" : known === null ? "none" : known.toFixed(2),
        ];
      });
      return [[context.systemTitle(k), plain(shape.sphericity, 3), ...cells]];
    }),
  );
  if (!rows.length) return null;
  const head = [1, 2, 3].flatMap((n) => [
    `peak ${n}`,
    n === 1 ? "<i>D</i><sub>1</sub>, <i>J</i><sub>1</sub>" : `<i>D</i><sub>${n}</sub>`,
    "S3",
  ]);
  return figure("", [table("numbers", ["system", "<i>ψ</i>", ...head], rows)], {
    text:
      "Peaks of the radial distribution in units of <i>L</i>, the distances of the closest configurations (<i>D</i><sub>n</sub> of " +
      "crosses, <i>J</i><sub>1</sub> of stars in three dimensions), and what S3 prints. A peak is the maximum of the curve smoothed over three bins.",
    source: "S3 Table 2 and text.",
  });
}

