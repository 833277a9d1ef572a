// The functions N_i^*(rho): how many points of the persistence diagrams lie in each bin.
import type { Context, Section } from "../context";
import { grainsOf, jammingSymbol } from "../data";
import { figure, h, indexed } from "../dom";

const BINS = ["rough", "strong", "medium", "weak"];

const hasLoops = (context: Context) => BINS.some((bin) => context.lines(`b1_${bin}`).length);

/** S1 counts per packing; S2, and packings of different size, per grain. */
function perGrain(context: Context): boolean {
  const { study } = context.data;
  const sizes = new Set(study.systems.map((_, system) => grainsOf(study, system)));
  return study.measure.force === "total" || sizes.size > 1;
}

export const generators: Section = {
  id: "generators",
  title: (context) => `The landscape of forces in ${hasLoops(context) ? "eight" : "four"} numbers`,
  build(context) {
    const each = perGrain(context);
    const scale = each ? (system: number) => 1 / grainsOf(context.data.study, system) : undefined;
    const over = each ? "/<i>N</i>" : "";
    const loops = hasLoops(context);
    const panels = (loops ? [0, 1] : [0]).flatMap((dimension) =>
      BINS.map((bin) =>
        context.overRho(
          `b${dimension}_${bin}`,
          `${indexed("N", bin[0].toUpperCase(), String(dimension))}${over} <span class="what">${bin} ${dimension ? "loops" : "components"}</span>`,
          { zero: true, height: 200 },
          scale,
        ),
      ),
    );
    if (!panels.some(Boolean)) return null;
    const slots = panels.map((panel) => panel ?? h("div"));
    return [
      figure("", [h("div", "grid four", ...slots)], {
        text:
          `Number of components ${loops ? "(upper row) and loops (lower row) " : ""}of the force network in each bin of the persistence ` +
          `diagram, per ${each ? "grain" : "packing"}: mean over realisations, band ± one standard error. Triangles on the axis mark each ` +
          `system's ${jammingSymbol(context.data)}. Drag across a panel to zoom all of them, double-click to return.`,
        formula: `${indexed("N", "*", "<i>i</i>")}(<i>ρ</i>) = number of <i>β<sub>i</sub></i> points in bin *`,
        source: each ? "S2 Sec. 5.3, Fig. 11; S1 Figs. 5 and 6." : "S1 Sec. III.A, Figs. 5 and 6.",
      }),
    ];
  },
};
