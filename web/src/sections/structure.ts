// Contacts and order: Z, rattlers, psi_6, g(d).
import type { Context, Section } from "../context";
import { dimensionOf, jammingSymbol } from "../data";
import { figure, h } from "../dom";
import { plain } from "../numbers";

const Z = "<i>Z</i> <span class=\"what\">contacts per grain";

export const coordination: Section = {
  id: "coordination",
  title: "Contacts",
  build(context) {
    const crossing = context.data.transitions?.jamming.some((point) => point?.quantity === "rho_c") ?? true;
    const symbol = jammingSymbol(context.data);
    const bare = context.lines("z_backbone");
    const values = [...context.lines("z"), ...bare].flatMap((line) => line.y.map((v) => v ?? 0));
    const common = { zero: true, height: 320, marks: context.marks("line"), level: crossing ? 3 : undefined };
    // On one scale where both are shown.
    const range = bare.length ? { yRange: [0, 1.06 * values.reduce((a, b) => Math.max(a, b), 0)] as [number, number] } : {};
    const z = context.overRho("z", `${Z}${bare.length ? ", all grains" : ""}</span>`, { ...common, ...range });
    const backbone = context.overRho("z_backbone", `${Z} without rattlers</span>`, { ...common, ...range });
    const rattlers = context.overRho("rattlers", "<span class=\"what\">fraction of grains with fewer than two contacts</span>", {
      zero: true,
      height: backbone ? 240 : 320,
    });
    const contacts = [z, backbone].filter((panel) => panel !== null);
    const out: HTMLElement[] = [];
    if (contacts.length)
      out.push(
        figure("", [contacts.length > 1 ? h("div", "grid two", ...contacts) : contacts[0]], {
          text:
            "Mean number of contacts per grain. " +
            (crossing
              ? `The dashed lines stand at ${symbol}, where the mean curve crosses 3 (grey line) for the last time; below it, ` +
                "grains touch only in passing."
              : `The dashed lines stand at ${symbol}, the inflection of the mean curve of all grains.`),
          formula:
            "<i>Z</i> = 2 <i>N</i><sub>pp</sub> / <i>N</i>, contacts with walls not counted" +
            (backbone ? "; rattlers, grains with fewer than two contacts, are removed once" : ", all grains"),
          source: crossing ? "S1 Table I." : "S2 Sec. 4.",
        }),
      );
    const lower = [rattlers && rattlersFigure(rattlers), percolation(context)].filter((f) => f !== null);
    if (!out.length && !lower.length) return null;
    if (contacts.length > 1) return [...out, h("div", `grid ${lower.length > 1 ? "two" : "one"}`, ...lower)];
    out.push(...lower);
    return [h("div", out.length > 1 ? "grid wide-left" : "grid one", ...out)];
  },
};

function rattlersFigure(panel: HTMLElement): HTMLElement {
  return figure("", [panel], { text: "Grains that carry no force: they touch fewer than two others or walls." });
}

/** How much of a packing its percolating clusters hold, at no threshold, and what a random network would need. */
function percolation(context: Context): HTMLElement | null {
  const lines = context.lines("percolating_fraction");
  if (!lines.length) return null;
  const estimate = context
    .lines("percolation_estimate")
    .map((line) => ({ ...line, y: line.y.map((v) => (v !== null && v <= 1 ? v : null)), label: `${line.label}, estimate`, dash: [3, 4], width: 1.3, points: false, se: undefined, unrelaxed: undefined, marked: undefined }));
  const panel = context.curves([...lines, ...estimate], {
    title: "<i>N</i><sub>per</sub>/<i>N</i> <span class=\"what\">grains in percolating clusters, <i>F</i><sub>th</sub> = 0</span>",
    marks: context.marks(),
    sync: "rho",
    height: 240,
    yRange: [0, 1.05],
  });
  return figure("", [panel], {
    text:
      "Part of the grains in clusters that join two opposite walls: mean over the packings that have one, left out where " +
      "fewer than half of them do. Dotted: the least part of the grains that percolates in a random network with as many " +
      "contacts.",
    formula: "estimate ⟨<i>k</i>⟩ / (⟨<i>k</i><sup>2</sup>⟩ − ⟨<i>k</i>⟩)",
    source: "S2 Eq. 6, Fig. 5.",
  });
}

const ORDER: [string, string][] = [
  ["psi6", "<i>ψ</i><sub>6</sub> <span class=\"what\">as in S1</span>"],
  ["psi6_local", "local <i>ψ</i><sub>6</sub>"],
  ["psi6_global", "global <i>ψ</i><sub>6</sub>"],
];

export const order: Section = {
  id: "order",
  title: "Order",
  build(context) {
    const out: HTMLElement[] = [];
    const panels = ORDER.map(([column, title]) => context.overRho(column, title, { height: 250 })).filter((p) => p !== null);
    if (panels.length)
      out.push(
        figure("", [h("div", "grid fit", ...panels)], {
          text:
            "Sixfold order of the bonds between touching grains: 1 in a perfect hexagonal crystal. S1 averages over the gaps " +
            "between consecutive bonds; the local form takes each grain by itself, the global one asks whether all grains " +
            "share one orientation.",
          formula:
            "S1: ⟨<i>N</i><sup>−1</sup> Σ<sub><i>j</i></sub> (<i>N</i><sub>b</sub>−1)<sup>−1</sup> Σ<sub><i>k</i></sub> cos 6<i>θ<sub>k</sub></i>⟩; " +
            "local: ⟨|⟨e<sup>6i<i>θ</i></sup>⟩|⟩; global: |⟨⟨e<sup>6i<i>θ</i></sup>⟩⟩|",
          source: "S1 Sec. III.B, Fig. 8.",
        }),
      );
    const pairs = context.data.distribution("pair_correlation");
    const lines = (pairs?.systems ?? []).flatMap((system, k) => {
      const last = system.frames[system.frames.length - 1];
      return last?.quantities.g ? [{ ...context.line(k, last.x, last.quantities.g), width: 1.4 }] : [];
    });
    if (pairs && lines.length) {
      const rhos = [...new Set(pairs.systems.flatMap((s) => s.frames.map((f) => f.rho)))];
      const at = rhos.length === 1 ? `<i>ρ</i> = ${plain(rhos[0], 3)}` : "the largest packing fraction of each system";
      const spheres = context.data.study.systems.some((_, k) => dimensionOf(context.data.study, k) === 3);
      const distances = { xLabel: "distance <i>d</i> in mean diameters", xName: "<i>d</i>", zero: true };
      const longest = Math.max(...lines.flatMap((l) => l.x));
      const near = context.chart({ ...distances, title: "<i>g</i>(<i>d</i>)", lines, height: 300, xRange: [0.5, Math.min(longest, 6)] });
      out.push(
        figure("", [near.element], {
          text:
            `Pair correlation at ${at}: how many grains lie at a distance, against a random arrangement ` +
            "of the same density. Sharp peaks far out mean a crystal; a first peak and little beyond it means disorder.",
          formula: `<i>g</i>(<i>d</i>) = pairs / (2π<i>d</i> Δ<i>d</i> <i>N ρ<sub>N</sub></i>/2)${spheres ? " for discs; 4π<i>d</i><sup>2</sup> for spheres" : ""}`,
          source: "S1 Sec. III.B, Fig. 7.",
        }),
      );
    }
    return out.length ? out : null;
  },
};
