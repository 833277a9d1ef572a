// What the reader has chosen, shared by all figures: the systems shown, and the packing fraction of the pictures.
import { startLook, startView, type Look, type View } from "./spheres/view";

export class Value<T> {
  private readonly listeners: ((value: T) => void)[] = [];
  constructor(private current: T) {}

  get(): T {
    return this.current;
  }
  set(value: T): void {
    this.current = value;
    for (const listener of this.listeners) listener(value);
  }
  /** Calls the listener now and after every change, until the function returned is called. */
  watch(listener: (value: T) => void): () => void {
    this.listeners.push(listener);
    listener(this.current);
    return () => void this.listeners.splice(this.listeners.indexOf(listener), 1);
  }
}

/**
 * "own": each system at the first picture where it is jammed; "last": at its densest; a number: all at this packing
 * fraction; "off:0.02": each this far above the packing fraction at which it jams; "stage:relax": each at the end of
 * this stage.
 */
export type FrameChoice = "own" | "last" | number | `off:${number}` | `stage:${string}`;

/** Abscissa of curves: the packing fraction, or how far above jamming it is. */
export type Abscissa = "rho" | "distance";

export class State {
  readonly shown: Value<boolean[]>;
  readonly frame = new Value<FrameChoice>("own");
  readonly abscissa = new Value<Abscissa>("rho");
  /** from where packings of spheres are seen, and what is drawn of them */
  readonly start: View;
  readonly view: Value<View>;
  readonly look: Value<Look>;

  constructor(systems: number, clusters: boolean) {
    this.start = startView(clusters ? "y" : "z");
    this.look = new Value<Look>(startLook(clusters));
    this.view = new Value<View>(this.start);
    this.shown = new Value(new Array<boolean>(systems).fill(true));
  }
}
