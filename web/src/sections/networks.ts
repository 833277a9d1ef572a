// Pictures of packings with their forces, at one packing fraction for all systems or each at its own jamming.
import { STRONGEST_STRESS } from "../clusters";
import type { Context, Section } from "../context";
import { jammingOf, type NetworkFrame } from "../data";
import { figure, h, markup } from "../dom";
import { choicesOf, chooser, pick } from "../frame_choice";
import { drawForceKey, drawPacking, drawStressKey, packingAspect, STRONGEST } from "../packing";
import { enlarged, picture, titleOf, type Draw } from "../picture";
import { drawSpheres, makeTurnable, spheresAspect } from "../spheres/picture";
import { sphereTools } from "../spheres/tools";

const isSpheres = (frame: NetworkFrame) => frame.axes.length === 3;
const isClusters = (frame: NetworkFrame) => frame.clusters !== undefined;

function networkDrawer(context: Context, chosen: () => NetworkFrame): Draw {
  const { view, look } = context.state;
  const waiting = new WeakMap<HTMLCanvasElement, number>();
  const draw: Draw = (canvas, size, turning = false) => {
    const frame = chosen();
    window.clearTimeout(waiting.get(canvas));
    if (!isSpheres(frame)) return drawPacking(canvas, frame, size, look.get());
    if (drawSpheres(canvas, frame, size, view.get(), look.get(), turning))
      waiting.set(canvas, window.setTimeout(() => draw(canvas, size), 350));
  };
  return draw;
}

/** Colours of forces and, where there are clusters, of stresses: the one that is drawn. */
function keys(context: Context, clusters: boolean): HTMLElement {
  const canvas = h("canvas");
  drawForceKey(canvas, 180, 16);
  const forces = h("div", "force-key", "0", canvas, markup(`${STRONGEST} <i>F̄</i>`));
  if (!clusters) return forces;
  const ramp = h("canvas");
  drawStressKey(ramp, 180, 14);
  const stress = h("div", "force-key", markup("<i>i</i> = 0"), ramp, markup(`≥ ${STRONGEST_STRESS}`));
  context.state.look.watch(({ what }) => {
    forces.hidden = what === "grains";
    stress.hidden = what !== "grains";
  });
  return h("div", "", forces, stress);
}

export const networks: Section = {
  id: "networks",
  title: (context) => (context.data.networks?.systems.flat().some(isClusters) ? "Packings and forces" : "Force networks"),
  build(context) {
    const { networks } = context.data;
    if (!networks?.systems.some((frames) => frames.length)) return null;
    if (!context.data.transitions || networks.systems.flat().some(isClusters))
      context.state.frame.set(choicesOf(context, networks.systems).pop()![0]);
    const { state } = context;
    const cells = networks.systems.flatMap((frames, system) => {
      if (!frames.length) return [];
      const three = isSpheres(frames[0]);
      const chosen = () => pick(frames, state.frame.get(), jammingOf(context.data, system))!;
      const aspect = () => (three ? spheresAspect : packingAspect)(chosen());
      const draw = networkDrawer(context, chosen);
      const canvas = picture(context, draw, three, aspect);
      canvas.setAttribute("aria-label", `packing and force network of ${context.data.study.systems[system].name}`);
      const open = () => enlarged(context, titleOf(context, system, chosen()), draw, three, aspect());
      if (three) {
        canvas.title = "drag to turn, click to enlarge";
        makeTurnable(canvas, state, open, false);
      } else {
        canvas.title = "click to enlarge";
        canvas.addEventListener("click", open);
      }
      const title = markup("", "div", "picture-title");
      state.frame.watch(() => (title.innerHTML = titleOf(context, system, chosen())));
      const element = h("div", "cell", title, canvas);
      context.hideWith(system, element);
      return [element];
    });
    const all = networks.systems.flat();
    const clusters = all.some(isClusters);
    const spheres = all.some(isSpheres);
    const tools = spheres || clusters ? [sphereTools(context, clusters, spheres)] : [];
    const bar = chooser(context, networks.systems);
    return [
      ...(bar ? [bar] : []),
      figure(
        "",
        [...tools, h("div", `pictures networks${cells.length > 8 ? " many" : ""}`, ...cells), keys(context, clusters)],
        clusters ? clusterCaption(context, spheres) : caption(context, all, spheres),
      ),
    ];
  },
};

function caption(context: Context, all: NetworkFrame[], spheres: boolean) {
  const total = context.data.study.measure.force === "total";
  return {
    text:
      `${total ? "Contact forces" : "Normal forces"} between the grains of one packing per system: the width of a line grows with ` +
      "its force and its colour darkens, in units of the mean force <i>F̄</i>; grains with fewer than two contacts are pale, " +
      `${all.some((f) => f.beads) ? "beads of the walls are grey, " : ""}forces on the walls end there. ` +
      (spheres
        ? "Drag a packing of spheres to turn it (arrow keys too; + and − change its size), click a picture to enlarge it. " +
          "Grains without forces take the colour of the largest force that acts on them."
        : "Click a picture to enlarge it."),
    source: `Realisation ${all[0].realisation}. Compare ${total ? "S2, Fig. 1" : "S1, Fig. 3"}.`,
  };
}

function clusterCaption(context: Context, three: boolean) {
  const total = context.data.study.measure.force === "total";
  return {
    text:
      "One packing per system. Grains take the colour of their stress <i>i</i>, the trace of the stress tensor of a grain in " +
      "units of its mean over all grains; those that touch nothing are pale. Lines of force join the centres of grains that " +
      `touch: their width and colour follow the ${total ? "" : "normal "}force between the two, summed over their contacts, in ` +
      "units of its mean <i>F̄</i>; forces on the walls end there. " +
      (three ? "Drag a packing in three dimensions to turn it (arrow keys too; + and − change its size), click" : "Click") +
      " a picture to enlarge it.",
    formula:
      "<i>i</i> = <i>I</i><sub>1</sub>/⟨<i>I</i><sub>1</sub>⟩, <i>I</i><sub>1</sub> = tr <i>σ</i>, " +
      "<i>σ<sub>ab</sub></i> = (1/<i>V</i>) Σ<sub>c</sub> <i>f<sub>a</sub> l<sub>b</sub></i> over the contacts of a grain, walls too",
    source: "Compare S3, Figs. 3 and 4.",
  };
}
