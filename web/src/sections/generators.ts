// The eight functions N_i^*(rho): how many points of the persistence diagrams lie in each bin.
import type { Section } from "../context";
import { figure, h, indexed } from "../dom";

const BINS = ["rough", "strong", "medium", "weak"];

export const generators: Section = {
  id: "generators",
  title: "The landscape of forces in eight numbers",
  build(context) {
    const panels = (dimension: number) =>
      BINS.map((bin) =>
        context.overRho(
          `b${dimension}_${bin}`,
          `${indexed("N", bin[0].toUpperCase(), String(dimension))} <span class="what">${bin} ${dimension ? "loops" : "components"}</span>`,
          { zero: true, height: 200 },
        ),
      );
    const components = panels(0);
    const loops = panels(1);
    const all = [...components, ...loops];
    if (!all.some(Boolean)) return null;
    const slots = all.map((panel) => panel ?? h("div"));
    return [
      figure("", [h("div", "grid four", ...slots)], {
        text:
          "Number of components (upper row) and loops (lower row) of the force network in each bin of the persistence " +
          "diagram, per packing: mean over realisations, band ± one standard error. Triangles on the axis mark each " +
          "system's <i>ρ</i><sub>c</sub>. Drag across a panel to zoom all of them, double-click to return.",
        formula: `${indexed("N", "*", "<i>i</i>")}(<i>ρ</i>) = number of <i>β<sub>i</sub></i> points in bin *`,
        source: "S1 Sec. III.A, Figs. 5 and 6.",
      }),
    ];
  },
};
