// Pictures of the force network and the persistence diagrams of the same packings, at one packing fraction for all
// systems or each at its own jamming.
import type { Context, Section } from "../context";
import { jammingOf, jammingSymbol, type NetworkFrame } from "../data";
import { figure, h, markup } from "../dom";
import { plain } from "../numbers";
import { drawForceKey, drawPacking, STRONGEST } from "../packing";
import { drawDiagram } from "../persistence";
import { drawSpheres, makeTurnable } from "../spheres/picture";
import { sphereTools } from "../spheres/tools";
import type { FrameChoice } from "../state";
import { systemColour } from "../theme";

/** The frame of a system that a choice means: the first at or above its jamming, or the nearest to a packing fraction. */
export function pick<F extends { rho: number }>(frames: F[], choice: FrameChoice, jamming: number | null): F | null {
  if (!frames.length) return null;
  if (choice === "own") return frames.find((f) => jamming !== null && f.rho >= jamming - 1e-9) ?? frames[frames.length - 1];
  return frames.reduce((best, f) => (Math.abs(f.rho - choice) < Math.abs(best.rho - choice) ? f : best));
}

/** Buttons for the packing fraction, and one that plays through all. */
function chooser(context: Context, rhos: number[]): HTMLElement {
  const { frame } = context.state;
  const choices: FrameChoice[] = context.data.transitions ? ["own", ...rhos] : rhos;
  const buttons = choices.map((choice) => {
    const text = choice === "own" ? `each just above its ${jammingSymbol(context.data)}` : plain(choice, 3);
    const button = h("button", "choice", markup(text));
    button.addEventListener("click", () => frame.set(choice));
    frame.watch((now) => button.setAttribute("aria-pressed", String(now === choice)));
    return button;
  });
  const play = h("button", "choice play", "▶ compress");
  let timer = 0;
  const stop = () => {
    window.clearInterval(timer);
    timer = 0;
    play.textContent = "▶ compress";
  };
  play.addEventListener("click", () => {
    if (timer) return stop();
    let k = 0;
    frame.set(rhos[0]);
    play.textContent = "■ stop";
    timer = window.setInterval(() => {
      k += 1;
      if (k < rhos.length) frame.set(rhos[k]);
      else stop();
    }, 700);
  });
  return h("div", "chooser", markup("<i>ρ</i> =", "span", "chooser-label"), ...buttons, ...(rhos.length > 2 ? [play] : []));
}

function rhosOf(systems: { rho: number; own?: boolean }[][]): number[] {
  const common = systems.flat().filter((f) => !f.own);
  return [...new Set(common.map((f) => f.rho))].sort((a, b) => a - b);
}

const isSpheres = (frame: NetworkFrame) => frame.axes.length === 3;

/** A canvas that is drawn again at its new size, and anew when the choice changes. */
function picture(
  context: Context,
  draw: (canvas: HTMLCanvasElement, size: number) => void,
  spheres = false,
): HTMLCanvasElement {
  const canvas = h("canvas", "picture");
  canvas.setAttribute("role", "img");
  let size = 0;
  new ResizeObserver(([entry]) => {
    const width = Math.floor(entry.contentRect.width);
    if (width < 20 || width === size) return;
    size = width;
    requestAnimationFrame(() => draw(canvas, size));
  }).observe(canvas);
  const redraw = onceAFrame(() => {
    if (size) draw(canvas, size);
  });
  const { frame, view, look } = context.state;
  frame.watch(redraw);
  if (spheres) for (const value of [view, look]) value.watch(redraw);
  return canvas;
}

/** At most one call each time the screen is drawn. */
function onceAFrame(call: () => void): () => void {
  let waiting = false;
  return () => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      call();
    });
  };
}

function enlarged(
  context: Context,
  title: string,
  draw: (canvas: HTMLCanvasElement, size: number) => void,
  turnable = false,
): void {
  const size = Math.min(window.innerWidth, window.innerHeight) - 90;
  const canvas = h("canvas", "large");
  canvas.style.width = canvas.style.height = `${size}px`;
  const dialog = h("dialog", "lightbox", markup(title, "div", "picture-title"), canvas);
  const redraw = onceAFrame(() => draw(canvas, size));
  const stop = turnable ? context.state.view.watch(redraw) : () => {};
  dialog.addEventListener("click", (event) => {
    if (!turnable || event.target !== canvas) dialog.close();
  });
  dialog.addEventListener("close", () => {
    stop();
    dialog.remove();
  });
  if (turnable) makeTurnable(canvas, context.state, null, true);
  document.body.append(dialog);
  dialog.showModal();
  draw(canvas, size);
}

function drawNetwork(context: Context, canvas: HTMLCanvasElement, frame: NetworkFrame, size: number): void {
  const { view, look } = context.state;
  if (isSpheres(frame)) drawSpheres(canvas, frame, size, view.get(), look.get());
  else drawPacking(canvas, frame, size);
}

function hideWithLegend(context: Context, system: number, element: HTMLElement): void {
  context.state.shown.watch((shown) => element.classList.toggle("off", !shown[system]));
}

function titleOf(context: Context, system: number, rho: number, what = ""): string {
  const label = context.labels[system] + (what && `<span class="what">${what}</span>`);
  return `<i class="swatch" style="background:${systemColour(system)}"></i><span>${label}</span><span class="rho"><i>ρ</i> = ${plain(rho, 4)}</span>`;
}

export const networks: Section = {
  id: "networks",
  title: "Force networks",
  build(context) {
    const { networks } = context.data;
    const rhos = rhosOf(networks?.systems ?? []);
    if (!networks || !rhos.length) return null;
    if (!context.data.transitions) context.state.frame.set(rhos[rhos.length - 1]);
    const { state } = context;
    const cells = networks.systems.flatMap((frames, system) => {
      if (!frames.length) return [];
      const chosen = () => pick(frames, state.frame.get(), jammingOf(context.data, system))!;
      const draw = (canvas: HTMLCanvasElement, size: number) => drawNetwork(context, canvas, chosen(), size);
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
      hideWithLegend(context, system, element);
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
      chooser(context, rhos),
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

export const diagrams: Section = {
  id: "diagrams",
  title: "Persistence diagrams",
  build(context) {
    const { diagrams } = context.data;
    const rhos = rhosOf(diagrams?.systems ?? []);
    if (!diagrams || !rhos.length) return null;
    if (!context.data.transitions && !context.data.networks) context.state.frame.set(rhos[rhos.length - 1]);
    const cells = diagrams.systems.flatMap((frames, system) => {
      if (!frames.length) return [];
      const chosen = () => pick(frames, context.state.frame.get(), jammingOf(context.data, system))!;
      const title = markup("", "div", "picture-title");
      context.state.frame.watch(() => (title.innerHTML = titleOf(context, system, chosen().rho)));
      const plots = frames[0].dimensions.map((_, dimension) => {
          const draw = (canvas: HTMLCanvasElement, size: number) => drawDiagram(canvas, chosen(), dimension, size);
          const canvas = picture(context, draw);
          const name = `<i>β</i><sub>${dimension}</sub> ${["components", "loops", "voids"][dimension]}`;
          canvas.title = "click to enlarge";
          canvas.setAttribute("aria-label", `persistence diagram, dimension ${dimension}, ${context.data.study.systems[system].name}`);
          canvas.addEventListener("click", () => enlarged(context, titleOf(context, system, chosen().rho, name), draw));
          return h("div", "diagram", markup(name, "div", "diagram-name"), canvas);
        });
      const element = h("div", "cell", title, h("div", "pair", ...plots));
      hideWithLegend(context, system, element);
      return [element];
    });
    return [
      chooser(context, rhos),
      figure("", [h("div", "pictures diagrams", ...cells)], {
        text:
          "Lowering a force threshold, a component or a loop of the network is born at one force and dies at a lower one: a " +
          "point of the diagram (in units of <i>F̄</i>, forces above 5 <i>F̄</i> set to 5 <i>F̄</i>). Far below the diagonal " +
          "are features that persist; the strip marked ∞ holds those that never die; darker points lie where many others do. " +
          "Lines are the borders of the bins rough, weak, medium and strong; the numbers count the points in each.",
        formula:
          "rough: <i>b</i> − <i>d</i> &lt; 0.1; else strong: <i>b</i> ≥ 2.5, medium: 1 ≤ <i>b</i> &lt; 2.5, weak: 0.1 ≤ <i>b</i> &lt; 1 " +
          "(a class that never dies has <i>d</i> = 0).",
        source: "S1 Sec. II.B–C, Figs. 2 and 4.",
      }),
    ];
  },
};
