// What every section is given, and what the sections share.
import type { Chart } from "./chart/chart";
import { chart } from "./chart/chart";
import type { ChartOptions, Line, Mark } from "./chart/options";
import type { Data, Estimate } from "./data";
import { jammingOf, jammingSymbol } from "./data";
import { h } from "./dom";
import type { State } from "./state";
import { clusterLabels, dashesOf, shapeRanks } from "./kinds";
import { systemLabel } from "./symbols";
import { assignColours, paletteColour, shapeColour, systemColour, systemDash } from "./theme";

export interface Section {
  id: string;
  title: string | ((context: Context) => string);
  /** null: the study has nothing for this section, which is then left out. */
  build(context: Context): HTMLElement[] | null;
}

export const RHO = "packing fraction <i>ρ</i>";

export class Context {
  readonly labels: string[];
  /** the chart that stands in a place now */
  private readonly refreshed = new Map<HTMLElement, Chart>();

  constructor(
    readonly data: Data,
    readonly state: State,
  ) {
    this.labels = clusterLabels(data) ?? data.study.systems.map((system) => systemLabel(data.study, system));
    // Shapes in the order of their arms; systems of one shape in several containers share its colour.
    const ranks = shapeRanks(data);
    const dashes = dashesOf(data);
    if (new Set(ranks).size > 1)
      assignColours(ranks.map((rank, k) => ({ colour: rank === null ? paletteColour(k) : shapeColour(rank), dash: dashes[k] })));
  }

  /** The label of a system after its colour. */
  systemTitle(system: number): string {
    return `<i class="swatch" style="background:${systemColour(system)}"></i>${this.labels[system]}`;
  }

  /** An element of one system, which the legend hides with it. */
  hideWith<E extends HTMLElement>(system: number, element: E): E {
    this.state.shown.watch((shown) => element.classList.toggle("off", !shown[system]));
    return element;
  }

  /** A chart that follows the legend. */
  chart(options: Omit<ChartOptions, "shown">): Chart {
    const made = chart({ ...options, shown: (system) => this.state.shown.get()[system] });
    this.state.shown.watch(() => made.refresh());
    return made;
  }

  line(system: number, x: number[], estimate: Estimate, scale = 1): Line {
    const scaled = (values: (number | null)[]) => values.map((v) => (v === null ? null : v * scale));
    return {
      label: this.labels[system],
      colour: systemColour(system),
      dash: systemDash(system),
      system,
      x,
      y: scale === 1 ? estimate.mean : scaled(estimate.mean),
      se: scale === 1 ? estimate.se : scaled(estimate.se),
    };
  }

  /** One line per system that has the column, over packing fraction. */
  lines(quantity: string, scale: (system: number) => number = () => 1): Line[] {
    const lines: Line[] = [];
    this.data.frames?.systems.forEach((frames, system) => {
      const estimate = frames.quantities[quantity];
      if (!estimate?.mean.some((v) => v !== null)) return;
      lines.push({ ...this.line(system, frames.rho, estimate, scale(system)), unrelaxed: frames.unrelaxed, marked: frames.marked });
    });
    return lines;
  }

  /** Where every system jams, as marks on the abscissa. */
  marks(kind: Mark["kind"] = "tick"): Mark[] {
    const marks: Mark[] = [];
    this.labels.forEach((_, system) => {
      const x = jammingOf(this.data, system);
      if (x !== null) marks.push({ x, colour: systemColour(system), system, kind });
    });
    return marks;
  }

  /** True where every system is known to jam, at packing fractions so different that curves lie far apart. */
  get farApart(): boolean {
    const points = this.labels.map((_, system) => jammingOf(this.data, system));
    const known = points.filter((p) => p !== null);
    return known.length === points.length && Math.max(...known) - Math.min(...known) > 0.1;
  }

  /** Lines over packing fraction, drawn anew when the reader asks for the distance from jamming instead. */
  curves(lines: Line[], options: Omit<ChartOptions, "shown" | "lines" | "xLabel" | "xName">): HTMLElement {
    const place = h("div");
    this.state.abscissa.watch((abscissa) => {
      if (this.refreshed.has(place) && !place.isConnected) return; // taken off the page meanwhile
      const shift = (system?: number) =>
        abscissa === "rho" || system === undefined ? 0 : (jammingOf(this.data, system) ?? 0);
      const symbol = abscissa === "rho" ? "<i>ρ</i>" : `<i>ρ</i> − ${jammingSymbol(this.data)}`;
      const made = chart({
        ...options,
        shown: (system) => this.state.shown.get()[system],
        xLabel: abscissa === "rho" ? RHO : symbol,
        xName: symbol,
        lines: lines.map((line) => ({ ...line, x: line.x.map((x) => round(x - shift(line.system))) })),
        marks: options.marks?.map((mark) => ({ ...mark, x: mark.x - shift(mark.system) })),
      });
      this.refreshed.set(place, made);
      place.replaceChildren(made.element);
    });
    this.state.shown.watch(() => this.refreshed.get(place)?.refresh());
    return place;
  }

  /** A quantity over packing fraction, or null when no system has it. */
  overRho(quantity: string, title: string, more: Partial<ChartOptions> = {}, scale?: (system: number) => number) {
    const lines = this.lines(quantity, scale);
    return lines.length ? this.curves(lines, { title, marks: this.marks(), sync: "rho", ...more }) : null;
  }
}

/** Differences of packing fractions, so that equal ones of several systems share a place. */
function round(x: number): number {
  return Math.round(x * 1e6) / 1e6;
}
