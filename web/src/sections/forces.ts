// The distribution of contact forces at several packing fractions, one panel per system.
import type { Line } from "../chart";
import type { Section } from "../context";
import { joinBins } from "../bins";
import { figure, h, markup } from "../dom";
import { plain } from "../numbers";
import { depth, hex } from "../theme";

/** Bins narrower than this, in mean forces, or with fewer contacts than LEAST are joined with their neighbours. */
const WIDTH = 0.1;
const LEAST = 10;

export const forces: Section = {
  id: "forces",
  title: "Distribution of forces",
  build(context) {
    const data = context.data.distribution("force_distribution");
    const all = data?.systems.flatMap((s) => s.frames) ?? [];
    const rhos = [...new Set(all.map((f) => f.rho))].sort((a, b) => a - b);
    if (!data || !rhos.length) return null;
    const shade = (rho: number) => depth(rhos.length > 1 ? (rho - rhos[0]) / (rhos[rhos.length - 1] - rhos[0]) : 1);
    const curves = new Map(
      data.systems.flatMap((system, k) => {
        const runs = context.data.study.systems[k].realisations;
        return system.frames.map((f) => {
          const counts = f.quantities.count?.mean.map((c) => (c ?? 0) * runs) ?? f.x.map(() => LEAST);
          return [f, joinBins({ x: f.x, ...f.quantities.density }, counts, WIDTH, LEAST)] as const;
        });
      }),
    );
    const values = [...curves.values()].flatMap((c) => c.mean.filter((v): v is number => v !== null && v > 0));
    if (!values.length) return null;
    const low = Math.min(Math.max(values.reduce((a, b) => Math.min(a, b)), 1e-4), 1e-2);
    const high = values.reduce((a, b) => Math.max(a, b));
    const panels = data.systems.flatMap((system, k) => {
      const lines: Line[] = system.frames.map((frame) => ({
        label: `<i>ρ</i> = ${plain(frame.rho, 3)}`,
        colour: hex(shade(frame.rho)),
        width: 1.6,
        points: false,
        band: 0.1,
        x: curves.get(frame)!.x,
        y: curves.get(frame)!.mean,
        se: curves.get(frame)!.se,
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
      figure("", [key, h("div", "grid fit", ...panels)], {
        text:
          "Probability density of the normal force at a contact, in units of its mean, on a logarithmic axis; darker curves " +
          "are denser packings. A straight line is an exponential tail, a curve bending down is closer to a Gaussian. " +
          `Bins are at least ${WIDTH} wide and hold at least ${LEAST} contacts.`,
        formula: "<i>P</i>(<i>F</i>/<i>F̄</i>), integral 1, averaged over realisations",
        source: "S1 Sec. III.B, Figs. 9 and 10.",
      }),
    ];
  },
};
