// Total persistence over packing fraction, and Betti numbers over the force threshold.
import type { Chart } from "../chart/chart";
import type { Line } from "../chart/options";
import type { Section } from "../context";
import { grainsOf } from "../data";
import { figure, h, markup } from "../dom";
import { plain } from "../numbers";

export const topology: Section = {
  id: "topology",
  title: "Topology of the force network",
  build(context) {
    const out: HTMLElement[] = [];
    const grains = (system: number) => 1 / grainsOf(context.data.study, system);
    const totals = [0, 1, 2]
      .map((k) =>
        context.overRho(
          `tp${k}`,
          `TP<sub>${k}</sub>/<i>N</i> <span class="what">${["components", "loops", "voids"][k]}</span>`,
          { zero: true },
          grains,
        ),
      )
      .filter((p) => p !== null);
    if (totals.length)
      out.push(
        figure("", [h("div", `grid ${totals.length === 3 ? "three" : "two"}`, ...totals)], {
          text:
            "Sum of all lifetimes per grain: how mountainous the landscape of forces is. A perfectly even load gives a small " +
            "value, isolated peaks and persistent loops a large one.",
          formula: "TP<sub><i>k</i></sub> = Σ (birth − death), classes that never die with death 0",
          source: context.data.surfaces ? "S2 Sec. 5.3, Fig. 12." : undefined,
        }),
      );

    // The surfaces show the same, and more.
    const data = context.data.surfaces ? null : context.data.distribution("betti");
    const rhos = [...new Set(data?.systems.flatMap((s) => s.frames.map((f) => f.rho)) ?? [])].sort((a, b) => a - b);
    if (data && rhos.length) {
      const linesAt = (quantity: string, rho: number): Line[] =>
        data.systems.flatMap((system, k) => {
          if (!system.frames.length) return [];
          const frame = system.frames.reduce((best, f) => (Math.abs(f.rho - rho) < Math.abs(best.rho - rho) ? f : best));
          return frame.quantities[quantity] ? [context.line(k, frame.x, frame.quantities[quantity])] : [];
        });
      const start = rhos.length - 1;
      const charts: [string, Chart][] = ["b0", "b1", "b2"].flatMap((quantity, k): [string, Chart][] => {
        const lines = linesAt(quantity, rhos[start]);
        if (!lines.length) return [];
        const title = `<i>B</i><sub>${k}</sub> <span class="what">${["components", "loops", "voids"][k]}</span>`;
        const xLabel = "force threshold <i>θ</i> in mean forces <i>F̄</i>";
        return [[quantity, context.chart({ title, xLabel, xName: "<i>θ</i>/<i>F̄</i>", lines, zero: true, sync: "theta" })]];
      });
      const slider = h("input");
      slider.type = "range";
      slider.min = "0";
      slider.max = String(rhos.length - 1);
      slider.value = String(start);
      slider.setAttribute("aria-label", "packing fraction");
      const value = markup("", "span", "slider-value");
      const show = () => {
        const rho = rhos[Number(slider.value)];
        value.innerHTML = `<i>ρ</i> = ${plain(rho, 3)}`;
        for (const [quantity, chart] of charts) chart.replace(linesAt(quantity, rho));
      };
      slider.addEventListener("input", show);
      show();
      const one = data.systems.every((system) => system.frames.length < 2); // final states, nothing to choose
      if (charts.length)
        out.push(
          figure("", [...(one ? [] : [h("div", "slider", slider, value)]), h("div", "grid two", ...charts.map(([, c]) => c.element))], {
            text:
              "Number of components and of loops in the part of the network that carries at least the force <i>θ</i>, " +
              `${one ? "in the final state" : "at one packing fraction: move the slider to compress"}. Loops of three touching ` +
              "grains are filled.",
            formula: "<i>B<sub>k</sub></i>(<i>θ</i>) of the clique complex of all contacts with <i>F</i> ≥ <i>θ</i>",
            source: "S1 Sec. II.B.",
          }),
        );
    }
    return out.length ? out : null;
  },
};
