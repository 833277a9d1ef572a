// Contacts and order: Z, rattlers, psi_6, g(d).
import type { Section } from "../context";
import { figure, h } from "../dom";
import { plain } from "../numbers";

export const coordination: Section = {
  id: "coordination",
  title: "Contacts",
  build(context) {
    const z = context.overRho("z", "<i>Z</i> <span class=\"what\">contacts per grain</span>", {
      zero: true,
      level: 3,
      height: 320,
      marks: context.marks("line"),
    });
    const rattlers = context.overRho("rattlers", "<span class=\"what\">fraction of grains with fewer than two contacts</span>", {
      zero: true,
      height: 320,
    });
    if (!z && !rattlers) return null;
    const out: HTMLElement[] = [];
    if (z)
      out.push(
        figure("", [z], {
          text:
            "Mean number of contacts per grain. The dashed lines stand at <i>ρ</i><sub>c</sub>, where the mean curve crosses " +
            "3 (grey line) for the last time; below it, grains touch only in passing.",
          formula: "<i>Z</i> = 2 <i>N</i><sub>pp</sub> / <i>N</i>, all grains, contacts with walls not counted",
          source: "S1 Table I.",
        }),
      );
    if (rattlers)
      out.push(
        figure("", [rattlers], {
          text: "Grains that carry no force: they touch fewer than two others or walls.",
        }),
      );
    return [h("div", out.length > 1 ? "grid wide-left" : "grid one", ...out)];
  },
};

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
      const rho = Math.max(...pairs.systems.flatMap((s) => s.frames.map((f) => f.rho)));
      const distances = { xLabel: "distance <i>d</i> in mean diameters", xName: "<i>d</i>", zero: true };
      const longest = Math.max(...lines.flatMap((l) => l.x));
      const near = context.chart({ ...distances, title: "<i>g</i>(<i>d</i>)", lines, height: 300, xRange: [0.5, Math.min(longest, 6)] });
      out.push(
        figure("", [near.element], {
          text:
            `Pair correlation at <i>ρ</i> = ${plain(rho, 3)}: how many grains lie at a distance, against a random arrangement ` +
            "of the same density. Sharp peaks far out mean a crystal; a first peak and little beyond it means disorder.",
          formula: "<i>g</i>(<i>d</i>) = pairs / (2π<i>d</i> Δ<i>d</i> <i>N ρ<sub>N</sub></i>/2)",
          source: "S1 Sec. III.B, Fig. 7.",
        }),
      );
    }
    return out.length ? out : null;
  },
};
