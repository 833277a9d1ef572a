// Stress, balance and energy: is the packing what it should be?
import type { ChartOptions } from "../chart/options";
import type { Section } from "../context";
import { grainsOf } from "../data";
import { figure, h } from "../dom";

const PANELS: { column: string; title: string; more?: Partial<ChartOptions>; perGrain?: boolean }[] = [
  { column: "pressure", title: "<i>p</i> <span class=\"what\">pressure from the contact forces</span>", more: { zero: true } },
  { column: "wall_pressure", title: "<i>p</i><sub>w</sub> <span class=\"what\">pressure on the walls</span>", more: { zero: true } },
  { column: "mean_normal_force", title: "<i>F̄</i> <span class=\"what\">mean contact force</span>", more: { zero: true } },
  { column: "unbalanced_force", title: "<span class=\"what\">net force on a grain over mean contact force</span>", more: { log: true } },
  { column: "kinetic", title: "<i>E</i><sub>kin</sub>/<i>N</i> <span class=\"what\">kinetic energy per grain</span>", more: { log: true }, perGrain: true },
  { column: "elastic", title: "<i>E</i><sub>el</sub>/<i>N</i> <span class=\"what\">elastic energy per grain</span>", more: { log: true }, perGrain: true },
];

export const mechanics: Section = {
  id: "mechanics",
  title: "Stress and energy",
  build(context) {
    const perGrain = (system: number) => 1 / grainsOf(context.data.study, system);
    const panels = PANELS.map((p) => context.overRho(p.column, p.title, p.more, p.perGrain ? perGrain : undefined)).filter(
      (p) => p !== null,
    );
    if (!panels.length) return null;
    return [
      figure("", [h("div", "grid fit", ...panels)], {
        text:
          "The mechanical state of the packings in units of the study (<i>d</i>, <i>m</i>, <i>τ</i><sub>c</sub>). Pressure and elastic energy " +
          "rise where the packing jams; the two pressures differ where rough walls carry shear. The unbalanced force says how " +
          "far from rest the grains are.",
        source: "theory sec. 4; S3 Eq. 8.",
        formula: "<i>p</i> = −tr <i>σ</i>/<i>D</i>, <i>σ<sub>ab</sub></i> = (1/<i>V</i>) Σ<sub>c</sub> <i>f<sub>a</sub> l<sub>b</sub></i>",
      }),
    ];
  },
};
