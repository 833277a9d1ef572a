// What is drawn of packings of spheres and clusters: grains, forces or both; forces from a threshold on; the front cut away.
import type { Context } from "../context";
import { h, markup } from "../dom";
import { plain } from "../numbers";
import { STRONGEST } from "../packing";
import { zoomed } from "./picture";
import type { Look } from "./view";

const WHAT: [Look["what"], string][] = [
  ["forces", "forces"],
  ["both", "forces and grains"],
  ["grains", "grains"],
];

/** Pictures of clusters begin with their stress. */
const WHAT_CLUSTERS: [Look["what"], string][] = [
  ["grains", "stress on grains"],
  ["both", "forces and grains"],
  ["forces", "forces"],
];

export function lookChoice(context: Context, clusters: boolean): HTMLElement {
  const { look } = context.state;
  const buttons = (clusters ? WHAT_CLUSTERS : WHAT).map(([what, name]) => {
    const button = h("button", "choice", name);
    button.addEventListener("click", () => look.set({ ...look.get(), what }));
    look.watch((now) => button.setAttribute("aria-pressed", String(now.what === what)));
    return button;
  });
  return h("span", "choices", ...buttons);
}

/** `turnable`: there are packings in three dimensions. */
export function sphereTools(context: Context, clusters: boolean, turnable: boolean): HTMLElement {
  const { look, view } = context.state;
  const least = slider("weakest force drawn", 0, STRONGEST, 0.05, (value) => look.set({ ...look.get(), least: value }));
  const cut = slider("part cut away in front", 0, 1, 0.01, (value) => look.set({ ...look.get(), cut: value }));
  const leastText = markup("", "span", "slider-value");
  look.watch((now) => (leastText.innerHTML = `forces ≥ ${plain(now.least, 3)} <i>F̄</i>`));
  const size = (text: string, title: string, click: () => void) => {
    const button = h("button", "", text);
    button.title = title;
    button.addEventListener("click", click);
    return button;
  };
  const common = [lookChoice(context, clusters), h("label", "", least, leastText)];
  if (!turnable) return h("div", "tools", ...common);
  return h(
    "div",
    "tools",
    ...common,
    h("label", "", cut, markup("cut", "span", "slider-value")),
    h(
      "span",
      "choices",
      size("−", "smaller", () => view.set(zoomed(view.get(), 1 / 1.25))),
      size("+", "larger", () => view.set(zoomed(view.get(), 1.25))),
      size("reset view", "as at first", () => view.set(context.state.start)),
    ),
  );
}

function slider(name: string, min: number, max: number, step: number, changed: (value: number) => void) {
  const input = h("input");
  input.type = "range";
  Object.assign(input, { min: String(min), max: String(max), step: String(step) });
  input.value = String(min);
  input.setAttribute("aria-label", name);
  input.title = name;
  input.addEventListener("input", () => changed(Number(input.value)));
  return input;
}
