// Quantities of the network of forces above a threshold, over packing fraction and threshold: maps of the systems side
// by side on one colour scale, and cuts through them.
import { chart } from "../chart/chart";
import type { Line } from "../chart/options";
import { RHO, type Context, type Section } from "../context";
import { grainsOf, jammingOf, jammingSymbol, type Estimate } from "../data";
import { figure, h, markup } from "../dom";
import { colourBar } from "../heat/colour_bar";
import { heatMap } from "../heat/heatmap";
import { plain } from "../numbers";
import { Value } from "../state";
import { depth, heat, hex } from "../theme";
import { QUANTITIES, type Quantity } from "./surface_quantities";

const THRESHOLD = "threshold <i>F</i><sub>th</sub> / <i>F̄</i>";
const THRESHOLDS = [0, 0.5, 1, 1.5, 2, 2.5];
/** How many packing fractions are cut at. */
const CUTS = 6;

/** One system's surface of one quantity, scaled as it is shown. */
interface Surface {
  system: number;
  rho: number[];
  thresholds: number[];
  unrelaxed?: number[];
  mean: (number | null)[];
  se: (number | null)[];
}

function surfacesOf(context: Context, quantity: Quantity): Surface[] {
  return (context.data.surfaces?.systems ?? []).flatMap((data, system) => {
    const estimate: Estimate | undefined = data.quantities[quantity.column];
    if (!estimate) return [];
    const scale = quantity.perGrain ? 1 / grainsOf(context.data.study, system) : 1;
    const scaled = (values: (number | null)[]) => values.map((v) => (v === null ? null : v * scale));
    return [{ system, rho: data.rho, thresholds: data.thresholds, unrelaxed: data.unrelaxed, mean: scaled(estimate.mean), se: scaled(estimate.se) }];
  });
}

function nearestIndex(values: number[], wanted: number): number {
  return values.reduce((best, v, k) => (Math.abs(v - wanted) < Math.abs(values[best] - wanted) ? k : best), 0);
}

/** Packing fractions to cut at: spread over those from a little below jamming on. */
function firstCuts(jamming: number | null, rho: number[]): number[] {
  const from = jamming === null ? 0 : Math.max(rho.findIndex((v) => v > jamming - 0.05), 0);
  const last = rho.length - 1;
  const count = Math.min(CUTS, last - from + 1);
  return Array.from({ length: count }, (_, k) => rho[from + Math.round((k * (last - from)) / Math.max(count - 1, 1))]);
}

/** Where all figures are cut: thresholds for all systems, packing fractions for each. */
class Cuts {
  readonly thresholds = new Value(THRESHOLDS);
  readonly rhos: Value<number[]>[];

  constructor(context: Context) {
    this.rhos = (context.data.surfaces?.systems ?? []).map(
      ({ rho }, system) => new Value(firstCuts(jammingOf(context.data, system), rho)),
    );
  }

  /** Adds a cut, or removes the one that is there; one stays. */
  static toggle(cuts: Value<number[]>, at: number): void {
    const others = cuts.get().filter((v) => Math.abs(v - at) > 1e-9);
    if (others.length === cuts.get().length) cuts.set([...others, at].sort((a, b) => a - b));
    else if (others.length) cuts.set(others);
  }
}

type Over = "rho" | "threshold";

/** A curve, and the threshold or packing fraction it is cut at. */
interface CutLine extends Line {
  at: number;
}

function linesOverRho(surface: Surface, thresholds: number[]): CutLine[] {
  const rows = surface.thresholds.length;
  const wanted = [...new Set(thresholds.map((v) => nearestIndex(surface.thresholds, v)))];
  return wanted.map((j, k) => ({
    at: surface.thresholds[j],
    label: `<i>F</i><sub>th</sub>/<i>F̄</i> = ${plain(surface.thresholds[j], 3)}`,
    colour: hex(heat(0.2 + (0.8 * k) / Math.max(wanted.length - 1, 1))),
    width: 1.7,
    x: surface.rho,
    y: surface.rho.map((_, i) => surface.mean[i * rows + j]),
    se: surface.rho.map((_, i) => surface.se[i * rows + j]),
    unrelaxed: surface.unrelaxed,
  }));
}

function linesOverThreshold(surface: Surface, rhos: number[]): CutLine[] {
  const rows = surface.thresholds.length;
  const wanted = [...new Set(rhos.map((v) => nearestIndex(surface.rho, v)))];
  return wanted.map((i, k) => ({
    at: surface.rho[i],
    label: `<i>ρ</i> = ${plain(surface.rho[i], 4)}${surface.unrelaxed?.[i] ? " ○" : ""}`,
    colour: hex(depth((k + 0.4) / wanted.length)),
    width: 1.7,
    points: false,
    x: surface.thresholds,
    y: surface.mean.slice(i * rows, (i + 1) * rows),
    se: surface.se.slice(i * rows, (i + 1) * rows),
  }));
}

function key(name: string, lines: Line[]): HTMLElement {
  const items = lines.map((line) => {
    const swatch = h("i", "swatch");
    swatch.style.background = line.colour;
    return h("span", "", swatch, markup(line.label.replace(/^.*= /, "")));
  });
  return h("div", "rho-key", markup(`${name} =`), ...items);
}

const NAMES = { rho: "<i>ρ</i>", threshold: "<i>F</i><sub>th</sub>/<i>F̄</i>" };

/** The cuts through one surface, drawn anew when the reader chooses others. */
function cutPanel(context: Context, surface: Surface, cuts: Cuts, over: Over, range: [number, number]): HTMLElement {
  const jamming = jammingOf(context.data, surface.system);
  const chosen = over === "rho" ? cuts.thresholds : cuts.rhos[surface.system];
  const place = h("div");
  chosen.watch((values) => {
    const lines = over === "rho" ? linesOverRho(surface, values) : linesOverThreshold(surface, values);
    const { element } = chart({
      title: context.systemTitle(surface.system),
      xLabel: over === "rho" ? RHO : THRESHOLD,
      xName: NAMES[over],
      lines,
      yRange: [range[0], range[1] + 0.05 * (range[1] - range[0])],
      height: 220,
      marks: over === "rho" && jamming !== null ? [{ x: jamming, colour: "#667085", kind: "line" }] : [],
    });
    place.replaceChildren(element, key(NAMES[over === "rho" ? "threshold" : "rho"], lines));
  });
  return context.hideWith(surface.system, place);
}

/** Maps side by side, and a row of cuts below; which way, the reader chooses. */
function mapsAndCuts(context: Context, surfaces: Surface[], cuts: Cuts, range: [number, number]): HTMLElement[] {
  const over = new Value<Over>("rho");
  const bar = colourBar(range);
  const maps = surfaces.map((surface) => {
    const map = heatMap({
      title: context.systemTitle(surface.system),
      xLabel: RHO,
      yLabel: THRESHOLD,
      xName: NAMES.rho,
      yName: NAMES.threshold,
      x: surface.rho,
      y: surface.thresholds,
      mean: surface.mean,
      se: surface.se,
      range,
      mark: jammingOf(context.data, surface.system),
      unrelaxed: surface.unrelaxed,
      pointed: bar.point,
      clicked: (rho, threshold) =>
        over.get() === "rho" ? Cuts.toggle(cuts.thresholds, threshold) : Cuts.toggle(cuts.rhos[surface.system], rho),
    });
    const show = () => {
      const along = over.get() === "rho";
      const values = along ? cuts.thresholds.get() : cuts.rhos[surface.system].get();
      map.show({ along, lines: along ? linesOverRho(surface, values) : linesOverThreshold(surface, values) });
    };
    for (const value of [over, cuts.thresholds, cuts.rhos[surface.system]] as Value<unknown>[]) value.watch(show);
    return context.hideWith(surface.system, map.element);
  });
  const rows: Record<Over, HTMLElement[]> = {
    rho: surfaces.map((surface) => cutPanel(context, surface, cuts, "rho", range)),
    threshold: surfaces.map((surface) => cutPanel(context, surface, cuts, "threshold", range)),
  };
  const place = h("div", "grid fit");
  const ways: [Over, string][] = [
    ["rho", "at thresholds, over packing fraction"],
    ["threshold", "at packing fractions, over threshold"],
  ];
  const buttons = ways.map(([way, name]) => {
    const button = h("button", "choice", name);
    button.addEventListener("click", () => over.set(way));
    over.watch((now) => button.setAttribute("aria-pressed", String(now === way)));
    return button;
  });
  over.watch((now) => place.replaceChildren(...rows[now]));
  const hint = markup("click a map to add or remove a cut", "span", "hint");
  return [
    h("div", "heat-row", h("div", "grid fit", ...maps), bar.element),
    h("div", "chooser cuts", ...buttons, hint),
    h("div", "heat-row", place, h("div", "colour-bar")),
  ];
}

export const surfaces: Section = {
  id: "surfaces",
  title: "Clusters and loops of the forces above a threshold",
  build(context) {
    const cuts = new Cuts(context);
    const out = QUANTITIES.flatMap((quantity) => {
      const all = surfacesOf(context, quantity);
      const values = all.flatMap((s) => s.mean.filter((v): v is number => v !== null));
      const largest = values.reduce((a, b) => Math.max(a, b), 0);
      if (largest <= 0) return [];
      const range: [number, number] = [0, largest];
      const unrelaxed = all.some((s) => s.unrelaxed?.some(Boolean));
      return [
        figure(quantity.title, mapsAndCuts(context, all, cuts, range), {
          text:
            `${quantity.text} Forces are in units of their mean <i>F̄</i>. All maps share one scale; the dashed line stands at ` +
            `${jammingSymbol(context.data)}.${unrelaxed ? " A circle marks packing fractions at which not all realisations were relaxed." : ""}`,
          formula: quantity.formula,
          source: quantity.source,
        }),
      ];
    });
    return out.length ? out : null;
  },
};
