// How the stress differs from grain to grain: P(i) per kind of container.
import type { Section } from "../context";
import { figure } from "../dom";
import { densityPanels } from "./contact_forces";

export const particleStress: Section = {
  id: "particle-stress",
  title: "Stress on the grains",
  build(context) {
    const i = "<i>i</i> = <i>I</i><sub>1</sub>/⟨<i>I</i><sub>1</sub>⟩";
    const panels = densityPanels(context, "stress_distribution", { xLabel: i, xName: "<i>i</i>" }, []);
    if (!panels) return null;
    return [
      figure("", [panels], {
        text:
          "Probability density of the stress of a grain, the trace of its stress tensor in units of the mean over all grains, in the final " +
          "state of each system; darker curves are rounder grains. Those that carry nothing are at 0.",
        formula: "<i>σ<sub>ab</sub></i> = (1/<i>V</i>) Σ<sub>c</sub> <i>f<sub>a</sub> l<sub>b</sub></i>, <i>I</i><sub>1</sub> = tr <i>σ</i>; <i>P</i>(<i>i</i>), integral 1",
        source: "S3 Eq. 8, Fig. 8.",
      }),
    ];
  },
};
