// A picture of a packing of spheres or clusters that can be turned: by dragging, by the arrow keys, larger with + and −.
import type { NetworkFrame } from "../data";
import { pixelRatio } from "../pixel_ratio";
import type { State } from "../state";
import { drawAxes } from "./box";
import { drawWithGl } from "./gl";
import { drawPlain } from "./plain";
import { sceneOf, type Scene } from "./scene";
import { aspectOf, turned, type Look, type View } from "./view";

/** A picture that takes longer than this, in ms, is turned as a draft: graphics cards are faster. */
const SLOW = 80;
/** Resolution of a draft, and how many contacts it has: the strongest. */
const DRAFT = 0.5;
const DRAFT_CONTACTS = 3000;
let slow = false;

/**
 * Draws a packing. On slow machines a picture that is being turned is a draft: coarse, and of the strongest forces only.
 * Returns true when this one is a draft that waits to be drawn in full.
 */
export function drawSpheres(
  canvas: HTMLCanvasElement,
  frame: NetworkFrame,
  size: number,
  view: View,
  look: Look,
  turning = false,
): boolean {
  return drawScene(canvas, sceneOf(frame), size, view, look, turning);
}

/** How many times its picture is higher than wide. */
export const spheresAspect = (frame: NetworkFrame): number => aspectOf(sceneOf(frame));

/** `size` is the width of the picture. */
export function drawScene(
  canvas: HTMLCanvasElement,
  scene: Scene,
  size: number,
  view: View,
  look: Look,
  turning = false,
  axes = true,
): boolean {
  const started = performance.now();
  const draft = turning && slow;
  const side = Math.round(size * pixelRatio * (draft ? DRAFT : 1));
  const height = Math.round(side * aspectOf(scene));
  if (canvas.width !== side || canvas.height !== height) [canvas.width, canvas.height] = [side, height];
  const ctx = canvas.getContext("2d")!;
  if (draft) drawPlain(ctx, scene, view, look, DRAFT_CONTACTS);
  else if (!drawWithGl(ctx, scene, view, look)) drawPlain(ctx, scene, view, look);
  if (axes) drawAxes(ctx, height, (side / size) * Math.min(Math.max(size / 420, 0.8), 1.5), view);
  if (!draft) slow = performance.now() - started > SLOW;
  return draft;
}

/** Radians per width of the picture. */
const TURN = 3;

export function zoomed(view: View, factor: number): View {
  return { ...view, zoom: Math.min(Math.max(view.zoom * factor, 0.6), 8) };
}

/** Lets the reader turn what the canvas shows. `clicked` is called for a press that was no drag. */
export function makeTurnable(canvas: HTMLCanvasElement, state: State, clicked: (() => void) | null, wheel: boolean): void {
  const { view } = state;
  canvas.tabIndex = 0;
  canvas.classList.add("turnable");
  let last: { x: number; y: number; moved: number } | null = null;
  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    last = { x: event.clientX, y: event.clientY, moved: 0 };
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!last) return;
    const [dx, dy] = [event.clientX - last.x, event.clientY - last.y];
    last = { x: event.clientX, y: event.clientY, moved: last.moved + Math.abs(dx) + Math.abs(dy) };
    const angle = TURN / canvas.clientWidth;
    view.set({ ...view.get(), rotation: turned(view.get().rotation, dx * angle, dy * angle) });
  });
  canvas.addEventListener("pointerup", () => {
    if (last && last.moved < 4) clicked?.();
    last = null;
  });
  canvas.addEventListener("pointercancel", () => (last = null));
  canvas.addEventListener(
    "wheel",
    (event) => {
      if (!wheel && !event.ctrlKey && !event.metaKey) return; // the page scrolls
      event.preventDefault();
      view.set(zoomed(view.get(), Math.exp(-event.deltaY / 500)));
    },
    { passive: false },
  );
  const keys: Record<string, () => View> = {
    ArrowLeft: () => ({ ...view.get(), rotation: turned(view.get().rotation, -0.1, 0) }),
    ArrowRight: () => ({ ...view.get(), rotation: turned(view.get().rotation, 0.1, 0) }),
    ArrowUp: () => ({ ...view.get(), rotation: turned(view.get().rotation, 0, -0.1) }),
    ArrowDown: () => ({ ...view.get(), rotation: turned(view.get().rotation, 0, 0.1) }),
    "+": () => zoomed(view.get(), 1.2),
    "-": () => zoomed(view.get(), 1 / 1.2),
    "0": () => state.start,
  };
  canvas.addEventListener("keydown", (event) => {
    const next = keys[event.key];
    if (!next) return;
    event.preventDefault();
    view.set(next());
  });
}
