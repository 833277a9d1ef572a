// Quantities of the network of forces above a threshold, over packing fraction and threshold: maps of the systems side
// by side on one colour scale, and cuts through them.
import { chart, type Line } from "../chart";
import { RHO, type Context, type Section } from "../context";
import { grainsOf, jammingOf, jammingSymbol, type Estimate } from "../data";
import { figure, h, markup } from "../dom";
import { colourBar, heatMap } from "../heatmap";
import { plain } from "../numbers";
import { depth, heat, hex } from "../theme";

interface Quantity {
  column: string;
  title: string;
  perGrain: boolean;
  text: string;
  formula: string;
  source: string;
}

const THRESHOLD = "threshold <i>F</i><sub>th</sub> / <i>F̄</i>";
const THRESHOLDS = [0, 0.5, 1, 1.5, 2, 2.5];
/** How many packing fractions are cut at. */
const CUTS = 6;

const QUANTITIES: Quantity[] = [
  {
    column: "mean_cluster_pooled",
    title: "⟨<i>S</i>⟩/<i>N</i> <span class=\"what\">mean size of a cluster</span>",
    perGrain: false,
    text:
      "Mean number of grains in a cluster that does not percolate, per grain of the packing. A cluster is what forces " +
      "above the threshold hold together.",
    formula: "grains in such clusters / (<i>N</i> × their number), pooled over realisations",
    source: "S2 Sec. 4.2, Fig. 4.",
  },
  {
    column: "percolating_grains",
    title: "<i>N</i><sub>per</sub>/<i>N</i> <span class=\"what\">grains in the percolating cluster</span>",
    perGrain: false,
    text:
      "Part of the grains that belong to a cluster which joins two opposite walls (or winds around a periodic box): mean " +
      "over the realisations that have one. Hatched: fewer than half of them do.",
    formula: "",
    source: "S2 Sec. 4.3, Fig. 5.",
  },
  {
    column: "b0",
    title: "<i>B</i><sub>0</sub>/<i>N</i> <span class=\"what\">clusters per grain</span>",
    perGrain: true,
    text: "Number of clusters, the percolating one included, per grain.",
    formula: "<i>B<sub>k</sub></i>: Betti numbers of the clique complex of all contacts with <i>F</i> > <i>F</i><sub>th</sub>",
    source: "S2 Sec. 5.1, Figs. 2 and 6.",
  },
  {
    column: "b1",
    title: "<i>B</i><sub>1</sub>/<i>N</i> <span class=\"what\">loops per grain</span>",
    perGrain: true,
    text: "Number of loops of four contacts or more per grain; loops of three touching grains are filled.",
    formula: "",
    source: "S2 Sec. 5.1, Fig. 7.",
  },
  {
    column: "b2",
    title: "<i>B</i><sub>2</sub>/<i>N</i> <span class=\"what\">voids per grain</span>",
    perGrain: true,
    text: "Number of voids enclosed by the network per grain, in three dimensions.",
    formula: "",
    source: "S2 Sec. 5.1.",
  },
  {
    column: "shape",
    title: "<i>S<sub>p</sub></i> <span class=\"what\">contacts per grain in a cluster</span>",
    perGrain: false,
    text:
      "Shape of the clusters: an open path has less than 1, a ring 1, an entangled cluster more. Zero where at least half " +
      "of the realisations have no cluster.",
    formula: "<i>S<sub>p</sub></i> = ⟨contacts/grains⟩ over the clusters of a realisation, percolating ones included",
    source: "S2 Sec. 5.2, Figs. 8 and 9.",
  },
];

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

function hiddenWithLegend(context: Context, system: number, element: HTMLElement): HTMLElement {
  context.state.shown.watch((shown) => element.classList.toggle("off", !shown[system]));
  return element;
}

function maps(context: Context, surfaces: Surface[], range: [number, number]): HTMLElement {
  const bar = colourBar(range, "");
  const panels = surfaces.map((surface) =>
    hiddenWithLegend(
      context,
      surface.system,
      heatMap({
        title: context.systemTitle(surface.system),
        xLabel: RHO,
        yLabel: THRESHOLD,
        xName: "<i>ρ</i>",
        yName: "<i>F</i><sub>th</sub>/<i>F̄</i>",
        x: surface.rho,
        y: surface.thresholds,
        mean: surface.mean,
        se: surface.se,
        range,
        mark: jammingOf(context.data, surface.system),
        unrelaxed: surface.unrelaxed,
        pointed: bar.point,
      }),
    ),
  );
  return h("div", "heat-row", h("div", "grid fit", ...panels), bar.element);
}

function nearestIndex(values: number[], wanted: number): number {
  return values.reduce((best, v, k) => (Math.abs(v - wanted) < Math.abs(values[best] - wanted) ? k : best), 0);
}

/** Packing fractions to cut at: spread over those from a little below jamming on. */
function cutsOf(context: Context, surface: Surface): number[] {
  const jamming = jammingOf(context.data, surface.system);
  const from = jamming === null ? 0 : Math.max(surface.rho.findIndex((rho) => rho > jamming - 0.05), 0);
  const last = surface.rho.length - 1;
  const count = Math.min(CUTS, last - from + 1);
  return Array.from({ length: count }, (_, k) => from + Math.round((k * (last - from)) / Math.max(count - 1, 1)));
}

function linesOverRho(surface: Surface): Line[] {
  const rows = surface.thresholds.length;
  const wanted = [...new Set(THRESHOLDS.map((v) => nearestIndex(surface.thresholds, v)))];
  return wanted.map((j, k) => ({
    label: `<i>F</i><sub>th</sub>/<i>F̄</i> = ${plain(surface.thresholds[j], 3)}`,
    colour: hex(heat(0.2 + (0.8 * k) / Math.max(wanted.length - 1, 1))),
    width: 1.7,
    x: surface.rho,
    y: surface.rho.map((_, i) => surface.mean[i * rows + j]),
    se: surface.rho.map((_, i) => surface.se[i * rows + j]),
    unrelaxed: surface.unrelaxed,
  }));
}

function linesOverThreshold(surface: Surface, cuts: number[]): Line[] {
  const rows = surface.thresholds.length;
  return cuts.map((i, k) => ({
    label: `<i>ρ</i> = ${plain(surface.rho[i], 4)}${surface.unrelaxed?.[i] ? " ○" : ""}`,
    colour: hex(depth((k + 0.4) / cuts.length)),
    width: 1.7,
    points: false,
    x: surface.thresholds,
    y: surface.mean.slice(i * rows, (i + 1) * rows),
    se: surface.se.slice(i * rows, (i + 1) * rows),
  }));
}

function key(lines: Line[]): HTMLElement {
  const items = lines.map((line) => {
    const swatch = h("i", "swatch");
    swatch.style.background = line.colour;
    return h("span", "", swatch, markup(line.label.replace(/^.*= /, "")));
  });
  return h("div", "rho-key", ...items);
}

/** A row of panels with cuts; which way, the reader chooses. */
function cuts(context: Context, surfaces: Surface[], range: [number, number]): HTMLElement[] {
  const pad = 0.05 * (range[1] - range[0]);
  const row = (over: "rho" | "threshold") =>
    surfaces.map((surface) => {
      const lines = over === "rho" ? linesOverRho(surface) : linesOverThreshold(surface, cutsOf(context, surface));
      const jamming = jammingOf(context.data, surface.system);
      const panel = chart({
        title: context.systemTitle(surface.system),
        xLabel: over === "rho" ? RHO : THRESHOLD,
        xName: over === "rho" ? "<i>ρ</i>" : "<i>F</i><sub>th</sub>/<i>F̄</i>",
        lines,
        yRange: [range[0], range[1] + pad],
        height: 220,
        marks: over === "rho" && jamming !== null ? [{ x: jamming, colour: "#667085", kind: "line" }] : [],
      }).element;
      const name = over === "rho" ? "<i>F</i><sub>th</sub>/<i>F̄</i> =" : "<i>ρ</i> =";
      const legend = key(lines);
      legend.prepend(markup(name));
      return hiddenWithLegend(context, surface.system, h("div", "", panel, legend));
    });
  const place = h("div", "grid fit");
  const ways: ["rho" | "threshold", string][] = [
    ["rho", "at thresholds, over packing fraction"],
    ["threshold", "at packing fractions, over threshold"],
  ];
  const buttons = ways.map(([over, name]) => {
    const button = h("button", "choice", name);
    button.addEventListener("click", () => show(over));
    return button;
  });
  const show = (over: "rho" | "threshold") => {
    place.replaceChildren(...row(over));
    ways.forEach(([way], k) => buttons[k].setAttribute("aria-pressed", String(way === over)));
  };
  show("rho");
  return [h("div", "chooser cuts", ...buttons), h("div", "heat-row", place, h("div", "colour-bar"))];
}

export const surfaces: Section = {
  id: "surfaces",
  title: "Clusters and loops of the forces above a threshold",
  build(context) {
    const out = QUANTITIES.flatMap((quantity) => {
      const all = surfacesOf(context, quantity);
      const values = all.flatMap((s) => s.mean.filter((v): v is number => v !== null));
      const largest = values.reduce((a, b) => Math.max(a, b), 0);
      if (largest <= 0) return [];
      const range: [number, number] = [0, largest];
      const unrelaxed = all.some((s) => s.unrelaxed?.some(Boolean));
      return [
        figure(quantity.title, [maps(context, all, range), ...cuts(context, all, range)], {
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
