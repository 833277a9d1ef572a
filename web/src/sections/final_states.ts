// The final states of containers: how dense they are, and their numbers.
import type { Context, Section } from "../context";
import { dimensionOf, finalValue, shapeOf } from "../data";
import { figure, h, table } from "../dom";
import { plain, withError } from "../numbers";
import { overSphericity } from "../over_sphericity";

/** Columns of the table, by quantity. */
const COLUMNS: [string, string][] = [
  ["solid_fraction", "solid fraction"],
  ["area_fraction", "area fraction"],
  ["height", "height/<i>d</i>"],
  ["z", "<i>Z</i> <small>touching grains</small>"],
  ["rattlers", "rattlers"],
  ["weight_over_load", "weight/load"],
  ["deepest_overlap", "deepest overlap/<i>d</i>"],
  ["unbalanced_force", "unbalanced force"],
  ["force_contacts", "contacts"],
  ["tail_k", "<i>k</i>"],
  ["tail_k_loglinear", "<i>k</i> <small>log-linear</small>"],
  ["tail_k_mle", "<i>k</i> <small>likelihood</small>"],
  ["type_a", "type A"],
  ["peak_position", "peak of <i>P</i>(<i>f</i>)"],
  ["fraction_above_8", "part of <i>f</i> &gt; 8"],
  ["largest_force", "largest <i>f</i>"],
];

export const finalStates: Section = {
  id: "final",
  title: "Final states",
  build(context) {
    const density = densities(context);
    const numbers = numbersTable(context);
    const out = [...(density ? [density] : []), ...(numbers ? [numbers] : [])];
    return out.length ? out : null;
  },
};

function densities(context: Context): HTMLElement | null {
  const charts = [
    overSphericity(context, "solid_fraction", "<i>φ</i> <span class=\"what\">solid fraction</span>"),
    overSphericity(context, "area_fraction", "<i>φ</i><sub>A</sub> <span class=\"what\">area fraction in two dimensions</span>", [], {}, 2),
    overSphericity(context, "z", "<i>Z</i> <span class=\"what\">grains that a grain touches</span>", [], { zero: true }),
  ].filter((c) => c !== null);
  if (!charts.length) return null;
  return figure("", [h("div", charts.length > 1 ? "grid fit" : "", ...charts)], {
    text:
      "How densely the grains fill their container under the lid, and how many neighbours they touch. S3 finds the largest solid fraction " +
      "at <i>ψ</i> between .90 and .95 (<i>L</i>/<i>d</i> near 1.7), and less the longer the arms are.",
    formula: "<i>φ</i> = <i>N</i>⟨<i>V</i>⟩ / volume below the lid; in two dimensions of thickness <i>d</i>",
    source: "S3, Data analysis and Supplement.",
  });
}

function numbersTable(context: Context): HTMLElement | null {
  const systems = context.data.final?.systems ?? [];
  const shown = COLUMNS.filter(([name]) => systems.some((_, k) => finalValue(context.data, k, name)));
  const rows = systems.flatMap((system, k) => {
    if (!system) return [];
    const shape = shapeOf(context.data, k);
    const cells = shown.map(([name]) => {
      if (name === "area_fraction" && dimensionOf(context.data.study, k) === 3) return "–";
      const value = finalValue(context.data, k, name);
      return value ? withError(value.mean, value.se) : "–";
    });
    return [[context.systemTitle(k), shape ? plain(shape.sphericity, 3) : "–", String(system.realisations), ...cells]];
  });
  if (!rows.length || !shown.length) return null;
  const head = ["system", "<i>ψ</i>", "runs", ...shown.map(([, title]) => title)];
  return figure("", [table("numbers", head, rows)], {
    text:
      "Means over realisations with their standard errors, at the end of the last stage; what is read off <i>P</i>(<i>f</i>) is read off " +
      "that of all realisations together where it was pooled. The lid carries the load and the grains carry their own " +
      "weight: where weight/load is not small, forces grow downwards. Three ways to fit the tail's exponent differ by about .1.",
    source: "S3 Methods; theory sec. 4.",
  });
}
