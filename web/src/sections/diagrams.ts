// Persistence diagrams of the pictured packings.
import type { Section } from "../context";
import { jammingOf } from "../data";
import { figure, h, markup } from "../dom";
import { choicesOf, chooser, pick } from "../frame_choice";
import { plain } from "../numbers";
import { drawDiagram, TOP } from "../persistence";
import { enlarged, picture, titleOf } from "../picture";

export const diagrams: Section = {
  id: "diagrams",
  title: "Persistence diagrams",
  build(context) {
    const { diagrams } = context.data;
    if (!diagrams?.systems.some((frames) => frames.length)) return null;
    if (!context.data.transitions && !context.data.networks)
      context.state.frame.set(choicesOf(context, diagrams.systems).pop()![0]);
    const { clamp, rough_includes_edge: edge } = context.data.study.measure;
    const cells = diagrams.systems.flatMap((frames, system) => {
      if (!frames.length) return [];
      const chosen = () => pick(frames, context.state.frame.get(), jammingOf(context.data, system))!;
      const title = markup("", "div", "picture-title");
      context.state.frame.watch(() => (title.innerHTML = titleOf(context, system, chosen())));
      const plots = frames[0].dimensions.map((_, dimension) => {
          const draw = (canvas: HTMLCanvasElement, size: number) => drawDiagram(canvas, chosen(), dimension, size);
          const canvas = picture(context, draw);
          const name = `<i>β</i><sub>${dimension}</sub> ${["components", "loops", "voids"][dimension]}`;
          canvas.title = "click to enlarge";
          canvas.setAttribute("aria-label", `persistence diagram, dimension ${dimension}, ${context.data.study.systems[system].name}`);
          canvas.addEventListener("click", () => enlarged(context, titleOf(context, system, chosen(), name), draw));
          return h("div", "diagram", markup(name, "div", "diagram-name"), canvas);
        });
      const element = h("div", "cell", title, h("div", plots.length > 2 ? "pair three" : "pair", ...plots));
      context.hideWith(system, element);
      return [element];
    });
    return [
      ...[chooser(context, diagrams.systems)].filter((bar) => bar !== null),
      figure("", [h("div", "pictures diagrams", ...cells)], {
        text:
          "Lowering a force threshold, a component or a loop of the network is born at one force and dies at a lower one: a " +
          `point of the diagram (in units of <i>F̄</i>${clamp ? `, forces above ${plain(clamp)} <i>F̄</i> set to ${plain(clamp)} <i>F̄</i>` : `, births above ${Math.floor(TOP)} <i>F̄</i> drawn at the border`}). Far below the diagonal ` +
          "are features that persist; the strip marked ∞ holds those that never die; darker points lie where many others do. " +
          "Lines are the borders of the bins rough, weak, medium and strong; the numbers count the points in each.",
        formula:
          `rough: <i>b</i> − <i>d</i> ${edge ? "≤" : "&lt;"} 0.1; else strong: <i>b</i> ≥ 2.5, medium: 1 ≤ <i>b</i> &lt; 2.5, weak: 0.1 ≤ <i>b</i> &lt; 1 ` +
          "(a class that never dies has <i>d</i> = 0).",
        source: `S1 Sec. II.B–C, Figs. 2 and 4${context.data.surfaces ? "; S2 Fig. 10" : ""}.`,
      }),
    ];
  },
};
