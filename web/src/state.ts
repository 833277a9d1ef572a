// What the reader has chosen, shared by all figures: the systems shown, and the packing fraction of the pictures.

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
  /** Calls the listener now and after every change. */
  watch(listener: (value: T) => void): void {
    this.listeners.push(listener);
    listener(this.current);
  }
}

/** "own": each system at the first picture above its own rho_c; a number: all at this packing fraction. */
export type FrameChoice = "own" | number;

export class State {
  readonly shown: Value<boolean[]>;
  readonly frame = new Value<FrameChoice>("own");

  constructor(systems: number) {
    this.shown = new Value(new Array<boolean>(systems).fill(true));
  }
}
