// Forces at the contacts of clusters, per kind of container: P(f), and the exponent of its tail over sphericity.
import type { Line } from "../chart/options";
import type { Context, Section } from "../context";
import type { FinalDistribution } from "../data";
import { figure, h } from "../dom";
import { containersOf, curveLabel, panelDash, type Kind } from "../kinds";
import { dashKey, overSphericity, referenceKey, type Reference } from "../over_sphericity";

const DARK = "#111827";
const GREY = "#8b95a5";

/** The axis ends below the smallest density, and here at the latest: one contact of 10⁵ in a bin of .2 is 5·10⁻⁵. */
const LOWEST = 1e-5;

/** The systems of one kind over each other; empty where none has the measure. */
export function densityLines(context: Context, data: FinalDistribution, kind: Kind): Line[] {
  return kind.systems.flatMap((k) => {
    const frame = data.systems[k].frames[0];
    const density = frame?.quantities.density_pooled ?? frame?.quantities.density;
    if (!density) return [];
    // Empty bins end the curve rather than fall to the bottom of the axis.
    const mean = density.mean.map((v) => (v === 0 ? null : v));
    const line = context.line(k, frame.x, { mean, se: density.se });
    return [{ ...line, label: curveLabel(context.data, k), dash: panelDash(context.data, k), width: 1.7, points: false, band: 0.12 }];
  });
}

/** One panel per kind of container on a logarithmic axis. */
export function densityPanels(
  context: Context,
  measure: string,
  axis: { xLabel: string; xName: string },
  references: Line[],
): HTMLElement | null {
  const data = context.data.finalDistribution(measure);
  const kinds = containersOf(context.data);
  if (!data || !kinds.length) return null;
  const curves = kinds.map((kind) => densityLines(context, data, kind));
  const values = curves.flat().flatMap((line) => line.y.filter((v): v is number => v !== null));
  const least = Math.max(values.reduce((a, b) => Math.min(a, b), 1) / 1.5, LOWEST);
  const panels = kinds.flatMap((kind, k) => {
    const lines = curves[k];
    if (!lines.length) return [];
    const made = context.chart({
      ...axis,
      title: kind.label,
      lines: [...lines, ...references],
      log: true,
      height: kinds.length > 1 ? 300 : 380,
      xRange: [0, 10],
      yRange: [least, 2],
      sync: measure,
    });
    return [made.element];
  });
  if (!panels.length) return null;
  return h("div", "", h("div", kinds.length > 1 ? "grid two" : "", ...panels), ...dashKey(context));
}

export const contactForces: Section = {
  id: "contact-forces",
  title: "Forces at the contacts",
  build(context) {
    const out = [distribution(context), tails(context)].filter((f) => f !== null);
    return out.length ? out : null;
  },
};

function distribution(context: Context): HTMLElement | null {
  const { conzelmann } = context.data;
  const mueth: Line[] = conzelmann
    ? [{ label: "Mueth et al.", colour: DARK, dash: [5, 4], width: 1.5, points: false, ...conzelmann.mueth }]
    : [];
  const f = "<i>f</i> = <i>F<sub>n</sub></i>/⟨<i>F<sub>n</sub></i>⟩";
  const panels = densityPanels(context, "contact_force_distribution", { xLabel: f, xName: "<i>f</i>" }, mueth);
  if (!panels) return null;
  const key = mueth.length ? [referenceKey([{ label: "Mueth et al. 1998: 3 (1 − .75 e<sup>−<i>f</i>²</sup>) e<sup>−1.5 <i>f</i></sup>", colour: DARK, dashed: true }])] : [];
  return figure("", [panels, ...key], {
    text:
      "Probability density of the normal forces at the contacts between grains, in units of their mean, in the final state of each " +
      "system; darker curves are rounder grains. A curve with a peak near 1 is of type A, one that falls from 0 on of type B; a " +
      "straight tail is exponential. Bins are .2 wide; forces beyond 10 count in the norm; empty bins leave a gap.",
    formula: "<i>P</i>(<i>f</i>), integral 1",
    source: "S3 Eq. 1, Figs. 1 and 5.",
  });
}

function tails(context: Context): HTMLElement | null {
  const { conzelmann } = context.data;
  const references: Reference[] = [];
  if (conzelmann) {
    const printed = (domain: string, marker: "square" | "diamond"): Line => {
      const rows = conzelmann.exponents.filter((row) => row.domain === domain);
      rows.sort((a, b) => a.sphericity - b.sphericity);
      return {
        label: `S3, ${domain}`,
        colour: GREY,
        marker,
        bars: true,
        x: rows.map((row) => row.sphericity),
        y: rows.map((row) => row.exponent),
        se: rows.map((row) => row.error),
      };
    };
    const fit = (label: string, curve: { x: number[]; y: number[] }, dash?: number[]): Line => ({
      label,
      colour: GREY,
      dash,
      width: 1.4,
      points: false,
      ...curve,
    });
    references.push(
      { line: fit("S3 fit, 2D", conzelmann.exponent_2d, [6, 4]), label: "S3, fit of 2D: 1.43 − .18 (1 − <i>ψ</i>)", dashed: true },
      {
        line: fit("S3 fit, slab 2 L", conzelmann.exponent_slab),
        label: "S3, fit of slabs <i>T</i> = 2 <i>L</i>: 1.29 − 2.03 (1 − <i>ψ</i>)<sup>2.43</sup>",
      },
      { line: printed("2D", "square"), label: "S3, 2D, values in the text", marker: "square" },
      { line: printed("slab and 3D", "diamond"), label: "S3, slabs and 3D, values in the text (mean above <i>ψ</i> = .7)", marker: "diamond" },
    );
  }
  const chart = overSphericity(context, "tail_k", "<i>k</i> <span class=\"what\">exponent of the tail</span>", references, {
    height: 340,
    marks: criticalMarks(context),
  });
  if (!chart) return null;
  return figure("", [chart], {
    text:
      "How fast the distribution falls beyond <i>f</i> = 1: a smaller exponent is a longer tail, so forces differ more. Least " +
      "squares on the bins with centre above 1, with a free prefactor (S3 prints none); bars are standard errors. The dashed lines " +
      "stand where arms stand out by exactly twice their radius: below, flat parts of two arms can touch.",
    formula: "<i>P</i>(<i>f</i>) = <i>A</i> e<sup>−<i>kf</i></sup>, <i>f</i> &gt; 1",
    source: "S3 Eq. 2, Fig. 6. Its printed linear fit rises with 1 − <i>ψ</i>, against figure and text: the sign is turned here.",
  });
}

/** Critical sphericities of the shapes that the study has. */
function criticalMarks(context: Context) {
  const { conzelmann, shapes } = context.data;
  const names = new Set((shapes?.systems ?? []).flatMap((s) => s?.map((shape) => shape.name) ?? []));
  const marks = [];
  if (conzelmann && names.has("cross")) marks.push({ x: conzelmann.critical.crosses, label: "crosses" });
  if (conzelmann && names.has("star")) marks.push({ x: conzelmann.critical.stars, label: "stars" });
  return marks.map((mark) => ({ ...mark, colour: GREY, kind: "line" as const }));
}
