// The distribution of contact forces at several packing fractions, one panel per system.
import type { Line } from "../chart";
import type { Section } from "../context";
import { figure, h, markup } from "../dom";
import { plain } from "../numbers";
import { depth } from "../theme";

export const forces: Section = {
  id: "forces",
  title: "Distribution of forces",
  build(context) {
    const data = context.data.distribution("force_distribution");
    const all = data?.systems.flatMap((s) => s.frames) ?? [];
    const rhos = [...new Set(all.map((f) => f.rho))].sort((a, b) => a - b);
    if (!data || !rhos.length) return null;
    const shade = (rho: number) => depth(rhos.length > 1 ? (rho - rhos[0]) / (rhos[rhos.length - 1] - rhos[0]) : 1);
    const values = all.flatMap((f) => (f.quantities.density?.mean ?? []).filter((v): v is number => v !== null && v > 0));
    if (!values.length) return null;
    const low = Math.max(values.reduce((a, b) => Math.min(a, b)), 3e-4);
    const high = values.reduce((a, b) => Math.max(a, b));
    const panels = data.systems.flatMap((system, k) => {
      const lines: Line[] = system.frames.map((frame) => ({
        label: `<i>ρ</i> = ${plain(frame.rho, 3)}`,
        colour: hex(shade(frame.rho)),
        width: 1.5,
        x: frame.x,
        y: frame.quantities.density.mean,
        se: frame.quantities.density.se,
      }));
      if (!lines.length) return [];
      const element = context.chart({
        title: context.labels[k],
        xLabel: "<i>F</i> / <i>F̄</i>",
        xName: "<i>F</i>/<i>F̄</i>",
        lines,
        log: true,
        height: 260,
        xRange: [0, 6],
        yRange: [low / 1.4, high * 1.4],
        sync: "force",
      }).element;
      context.state.shown.watch((shown) => element.classList.toggle("off", !shown[k]));
      return [element];
    });
    const key = h("div", "rho-key", markup("<i>ρ</i> ="));
    for (const rho of rhos) {
      const swatch = h("i", "swatch");
      swatch.style.background = shade(rho);
      key.append(h("span", "", swatch, plain(rho, 3)));
    }
    return [
      figure("", [key, h("div", "grid three", ...panels)], {
        text:
          "Probability density of the normal force at a contact, in units of its mean, on a logarithmic axis; darker curves " +
          "are denser packings. A straight line is an exponential tail, a curve bending down is closer to a Gaussian.",
        formula: "<i>P</i>(<i>F</i>/<i>F̄</i>), integral 1, averaged over realisations",
        source: "S1 Sec. III.B, Figs. 9 and 10.",
      }),
    ];
  },
};

function hex(rgb: string): string {
  const parts = rgb.match(/\d+/g)!.map(Number);
  return `#${parts.map((p) => p.toString(16).padStart(2, "0")).join("")}`;
}
