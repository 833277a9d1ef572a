// Pictures of packings with their forces, at one packing fraction for all systems or each at its own jamming.
import type { Context, Section } from "../context";
import { jammingOf, type NetworkFrame } from "../data";
import { figure, h, markup } from "../dom";
import { choicesOf, chooser, pick } from "../frame_choice";
import { drawForceKey, drawPacking, STRONGEST } from "../packing";
import { enlarged, picture, titleOf, type Draw } from "../picture";
import { drawSpheres, makeTurnable } from "../spheres/picture";
import { sphereTools } from "../spheres/tools";

const isSpheres = (frame: NetworkFrame) => frame.axes.length === 3;

function networkDrawer(context: Context, chosen: () => NetworkFrame): Draw {
  const { view, look } = context.state;
  const waiting = new WeakMap<HTMLCanvasElement, number>();
  const draw: Draw = (canvas, size, turning = false) => {
    const frame = chosen();
    window.clearTimeout(waiting.get(canvas));
    if (!isSpheres(frame)) return drawPacking(canvas, frame, size, look.get().least);
    if (drawSpheres(canvas, frame, size, view.get(), look.get(), turning))
      waiting.set(canvas, window.setTimeout(() => draw(canvas, size), 350));
  };
  return draw;
}

export const networks: Section = {
  id: "networks",
  title: "Force networks",
  build(context) {
    const { networks } = context.data;
    if (!networks?.systems.some((frames) => frames.length)) return null;
    if (!context.data.transitions) context.state.frame.set(choicesOf(context, networks.systems).pop()![0]);
    const { state } = context;
    const cells = networks.systems.flatMap((frames, system) => {
      if (!frames.length) return [];
      const chosen = () => pick(frames, state.frame.get(), jammingOf(context.data, system))!;
      const draw = networkDrawer(context, chosen);
      const canvas = picture(context, draw, isSpheres(frames[0]));
      canvas.setAttribute("aria-label", `force network of ${context.data.study.systems[system].name}`);
      const open = () => enlarged(context, titleOf(context, system, chosen().rho), draw, isSpheres(frames[0]));
      if (isSpheres(frames[0])) {
        canvas.title = "drag to turn, click to enlarge";
        makeTurnable(canvas, state, open, false);
      } else {
        canvas.title = "click to enlarge";
        canvas.addEventListener("click", open);
      }
      const title = markup("", "div", "picture-title");
      state.frame.watch(() => (title.innerHTML = titleOf(context, system, chosen().rho)));
      const element = h("div", "cell", title, canvas);
      context.hideWith(system, element);
      return [element];
    });
    const key = h("canvas");
    drawForceKey(key, 180, 16);
    const scale = h("div", "force-key", "0", key, markup(`${STRONGEST} <i>F̄</i>`));
    const all = networks.systems.flat();
    const total = context.data.study.measure.force === "total";
    const spheres = all.some(isSpheres);
    const tools = spheres ? [sphereTools(context)] : [];
    return [
      chooser(context, networks.systems),
      figure("", [...tools, h("div", "pictures networks", ...cells), scale], {
        text:
          `${total ? "Contact forces" : "Normal forces"} between the grains of one packing per system: the width of a line grows with ` +
          "its force and its colour darkens, in units of the mean force <i>F̄</i>; grains with fewer than two contacts are pale, " +
          `${all.some((f) => f.beads) ? "beads of the walls are grey, " : ""}forces on the walls end there. ` +
          (spheres
            ? "Drag a packing of spheres to turn it (arrow keys too; + and − change its size), click a picture to enlarge it. " +
              "Grains without forces take the colour of the largest force that acts on them."
            : "Click a picture to enlarge it."),
        source: `Realisation ${all[0].realisation}. Compare ${total ? "S2, Fig. 1" : "S1, Fig. 3"}.`,
      }),
    ];
  },
};
