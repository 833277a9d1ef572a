// Which of the stored packings is pictured, and the buttons that choose it for all pictures.
import type { Context } from "./context";
import { jammingOf, jammingSymbol } from "./data";
import { escape, h, markup } from "./dom";
import { plain } from "./numbers";
import type { FrameChoice } from "./state";

/** The frame of a system that a choice means, or null when it has none. */
export function pick<F extends { rho: number; stage?: string }>(frames: F[], choice: FrameChoice, jamming: number | null): F | null {
  if (!frames.length) return null;
  const last = frames[frames.length - 1];
  if (choice === "last") return last;
  if (typeof choice === "string" && choice.startsWith("stage:")) return frames.find((f) => f.stage === choice.slice(6)) ?? last;
  if (choice === "own") return frames.find((f) => jamming !== null && f.rho >= jamming - 1e-9) ?? last;
  const off = typeof choice === "string" ? Number(choice.slice(4)) : null;
  if (off !== null && jamming === null) return last;
  const rho = off === null ? (choice as number) : jamming! + off;
  return frames.reduce((best, f) => (Math.abs(f.rho - rho) < Math.abs(best.rho - rho) ? f : best));
}

type Framed = { rho: number; own?: boolean; stage?: string }[][];

/** More packing fractions than these are no choice any more. */
const MOST = 14;
const OFFS = [-0.1, -0.05, -0.02, 0, 0.02, 0.05, 0.1];

/**
 * What the reader may choose, in the order of compression: packing fractions that the systems share, or, where they
 * share none, distances from jamming.
 */
export function choicesOf(context: Context, systems: Framed): [FrameChoice, string][] {
  const stages = [...new Set(systems.flat().flatMap((f) => f.stage ?? []))];
  if (stages.length) return stages.map((stage) => [`stage:${stage}`, `after ${escape(stage)}`]);
  const symbol = jammingSymbol(context.data);
  const own: [FrameChoice, string] = ["own", `each just above its ${symbol}`];
  const rhos = rhosOf(systems);
  const jamming = systems.map((_, system) => jammingOf(context.data, system));
  const known = jamming.some((p) => p !== null);
  if ((rhos.length <= MOST && !context.farApart) || !known) {
    const all = rhos.map((rho): [FrameChoice, string] => [rho, plain(rho, 3)]);
    return known ? [own, ...all] : all;
  }
  const near = (off: number) =>
    systems.some((frames, k) => frames.some((f) => jamming[k] !== null && Math.abs(f.rho - jamming[k] - off) < 0.011));
  const offs = OFFS.filter((off) => off === 0 || near(off)).map((off): [FrameChoice, string] =>
    off === 0 ? own : [`off:${off}`, `${symbol} ${off < 0 ? "−" : "+"} ${Math.abs(off)}`],
  );
  return [...offs, ["last", "each at its densest"]];
}

/** Buttons for the packing fraction, and one that plays through all; nothing where there is no choice. */
export function chooser(context: Context, systems: Framed): HTMLElement | null {
  const { frame } = context.state;
  const choices = choicesOf(context, systems);
  const staged = systems.flat().some((f) => f.stage);
  if (staged && choices.length < 2) return null;
  const buttons = choices.map(([choice, text]) => {
    const button = h("button", "choice", markup(text));
    button.addEventListener("click", () => frame.set(choice));
    frame.watch((now) => button.setAttribute("aria-pressed", String(now === choice)));
    return button;
  });
  const steps = choices.filter(([choice], k) => choice !== "own" || k > 0).map(([choice]) => choice);
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
    frame.set(steps[0]);
    play.textContent = "■ stop";
    timer = window.setInterval(() => {
      k += 1;
      if (k < steps.length) frame.set(steps[k]);
      else stop();
    }, 700);
  });
  if (staged) return h("div", "chooser", ...buttons);
  return h("div", "chooser", markup("<i>ρ</i> =", "span", "chooser-label"), ...buttons, ...(steps.length > 2 ? [play] : []));
}

function rhosOf(systems: Framed): number[] {
  const common = systems.flat().filter((f) => !f.own);
  return [...new Set(common.map((f) => f.rho))].sort((a, b) => a - b);
}
