// Any column of the ensemble table over packing fraction.
import type { Section } from "../context";
import { figure, h } from "../dom";

export const explorer: Section = {
  id: "explorer",
  title: "All other quantities",
  build(context) {
    const names = [...new Set(context.data.frames?.systems.flatMap((s) => Object.keys(s.quantities)) ?? [])];
    const usable = names.filter((name) => context.lines(name).length);
    if (!usable.length) return null;
    const select = h("select");
    for (const name of usable) {
      const option = h("option", "", name);
      option.value = name;
      select.append(option);
    }
    select.setAttribute("aria-label", "quantity");
    select.value = usable.includes("contacts") ? "contacts" : usable[0];
    const place = h("div");
    const meaning = h("p", "note");
    const show = () => {
      const element = context.overRho(select.value, `<code>${select.value}</code>`, { height: 300 });
      place.replaceChildren(...(element ? [element] : []));
      const column = context.data.columns?.[select.value];
      const unit = column?.unit ? ` in ${column.unit}` : "";
      meaning.textContent = column ? `${column.text}${unit}. ${column.formula} ${column.source}.` : "";
    };
    select.addEventListener("change", show);
    show();
    return [
      figure("", [h("div", "slider", select), meaning, place], {
        text:
          "Every column of <code>ensemble/frames.csv</code>: mean over realisations, band ± one standard error.",
      }),
    ];
  },
};
