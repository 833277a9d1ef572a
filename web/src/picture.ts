// Canvases that follow the reader's choices, and what a click on one opens.
import type { Context } from "./context";
import { escape, h, markup } from "./dom";
import { plain } from "./numbers";
import { makeTurnable } from "./spheres/picture";
import { systemColour } from "./theme";

interface Framed {
  rho: number;
  stage?: string;
}

/** `turning`: the reader may be turning it; where that is slow a draft comes first, and the picture when he rests. */
export type Draw = (canvas: HTMLCanvasElement, size: number, turning?: boolean) => void;

/** A canvas that is drawn again at its new size, and anew when the choice changes; `aspect` is height over width. */
export function picture(context: Context, draw: Draw, spheres = false, aspect = () => 1): HTMLCanvasElement {
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
    if (size) draw(canvas, size, true);
  });
  context.state.frame.watch(() => (canvas.style.aspectRatio = String(1 / aspect())));
  const { frame, view, look } = context.state;
  frame.watch(redraw);
  look.watch(redraw);
  if (spheres) view.watch(redraw);
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

/** A large picture over the page. */
export function enlarged(context: Context, title: string, draw: Draw, turnable = false, aspect = 1): void {
  const size = Math.min(window.innerWidth - 90, (window.innerHeight - (turnable ? 120 : 90)) / aspect);
  const canvas = h("canvas", "large");
  canvas.style.width = `${size}px`;
  canvas.style.height = `${size * aspect}px`;
  const dialog = h("dialog", "lightbox", markup(title, "div", "picture-title"), canvas);
  if (turnable) dialog.append(markup("drag to turn, scroll for the size, Esc or a click outside to close", "div", "hint"));
  const redraw = onceAFrame(() => draw(canvas, size, true));
  const stops = [context.state.view, context.state.look].map((value) => value.watch(redraw as () => void));
  dialog.addEventListener("click", (event) => {
    if (!turnable || event.target !== canvas) dialog.close();
  });
  dialog.addEventListener("close", () => {
    for (const stop of stops) stop();
    dialog.remove();
  });
  if (turnable) makeTurnable(canvas, context.state, null, true);
  document.body.append(dialog);
  dialog.showModal();
  draw(canvas, size);
}

/** System and packing fraction over a picture. */
export function titleOf(context: Context, system: number, { rho, stage }: Framed, what = ""): string {
  const label = context.labels[system] + (what && `<span class="what">${what}</span>`);
  return `<i class="swatch" style="background:${systemColour(system)}"></i><span>${label}</span><span class="rho">${stage ? `${escape(stage)}, ` : ""}<i>ρ</i> = ${plain(rho, stage ? 3 : 4)}</span>`;
}
