// What every section is given, and what the sections share.
import type { Chart, ChartOptions, Line, Mark } from "./chart";
import { chart } from "./chart";
import type { Data, Estimate } from "./data";
import { jammingOf } from "./data";
import type { State } from "./state";
import { systemLabel } from "./symbols";
import { systemColour, systemDash } from "./theme";

export interface Section {
  id: string;
  title: string;
  /** null: the study has nothing for this section, which is then left out. */
  build(context: Context): HTMLElement[] | null;
}

export const RHO = "packing fraction <i>ρ</i>";

export class Context {
  readonly labels: string[];

  constructor(
    readonly data: Data,
    readonly state: State,
  ) {
    this.labels = data.study.systems.map((system) => systemLabel(data.study, system));
  }

  /** The label of a system after its colour. */
  systemTitle(system: number): string {
    return `<i class="swatch" style="background:${systemColour(system)}"></i>${this.labels[system]}`;
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
      lines.push({ ...this.line(system, frames.rho, estimate, scale(system)), unrelaxed: frames.unrelaxed });
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

  /** A quantity over packing fraction, or null when no system has it. */
  overRho(quantity: string, title: string, more: Partial<ChartOptions> = {}, scale?: (system: number) => number) {
    const lines = this.lines(quantity, scale);
    if (!lines.length) return null;
    return this.chart({ title, xLabel: RHO, xName: "<i>ρ</i>", lines, marks: this.marks(), sync: "rho", ...more })
      .element;
  }
}
