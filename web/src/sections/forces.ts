// The distribution of contact forces: per system at several packing fractions, and the systems over each other.
import { chart } from "../chart/chart";
import type { Line } from "../chart/options";
import type { Context, Section } from "../context";
import { joinBins, type Binned } from "../bins";
import { jammingOf, jammingSymbol, type Distribution } from "../data";
import { figure, h, markup } from "../dom";
import { plain } from "../numbers";
import { depth, hex } from "../theme";

/** Bins narrower than this, in mean forces, or with fewer contacts than LEAST are joined with their neighbours. */
const WIDTH = 0.1;
const LEAST = 10;
const AXIS = { xLabel: "<i>F</i> / <i>F̄</i>", xName: "<i>F</i>/<i>F̄</i>", xRange: [0, 6] as [number, number] };

type Curve = Binned & { rho: number };

function curvesOf(context: Context, data: Distribution): Curve[][] {
  return data.systems.map((system, k) => {
    const runs = context.data.study.systems[k].realisations;
    return system.frames.map((f) => {
      const counts = f.quantities.count?.mean.map((c) => (c ?? 0) * runs) ?? f.x.map(() => LEAST);
      return { rho: f.rho, ...joinBins({ x: f.x, ...f.quantities.density }, counts, WIDTH, LEAST) };
    });
  });
}

/** Ends of the ordinate that all panels share. */
function ends(curves: Curve[][]): { low: number; high: number } | null {
  const values = curves.flat().flatMap((c) => c.mean.filter((v): v is number => v !== null && v > 0));
  if (!values.length) return null;
  const least = values.reduce((a, b) => Math.min(a, b));
  return { low: Math.min(Math.max(least, 1e-4), 1e-2), high: values.reduce((a, b) => Math.max(a, b)) };
}

const yRange = (log: boolean, { low, high }: { low: number; high: number }): [number, number] =>
  log ? [low / 1.4, high * 1.4] : [0, high * 1.05];

function rhoKey(rhos: number[], shade: (rho: number) => string): HTMLElement {
  const key = h("div", "rho-key", markup("<i>ρ</i> ="));
  for (const rho of rhos) {
    const swatch = h("i", "swatch");
    swatch.style.background = shade(rho);
    key.append(h("span", "", swatch, plain(rho, 3)));
  }
  return key;
}

const shadeOver = (rhos: number[]) => (rho: number) =>
  hex(depth(rhos.length > 1 ? (rho - rhos[0]) / (rhos[rhos.length - 1] - rhos[0]) : 1));

/** One panel per system; one key for all where they share their packing fractions. */
function panels(context: Context, curves: Curve[][], log: boolean): HTMLElement[] {
  const rhosOf = (all: Curve[]) => [...new Set(all.map((c) => c.rho))].sort((a, b) => a - b);
  const all = rhosOf(curves.flat());
  const shared = all.length <= 16;
  const range = ends(curves)!;
  const out = curves.flatMap((own, k) => {
    if (!own.length) return [];
    const rhos = shared ? all : rhosOf(own);
    const shade = shadeOver(rhos);
    const lines: Line[] = own.map((curve) => ({
      label: `<i>ρ</i> = ${plain(curve.rho, 3)}`,
      colour: shade(curve.rho),
      width: 1.6,
      points: false,
      band: 0.1,
      x: curve.x,
      y: curve.mean,
      se: curve.se,
    }));
    const title = context.systemTitle(k);
    const { element } = chart({ ...AXIS, title, lines, log, height: 260, yRange: yRange(log, range), sync: "force" });
    return [context.hideWith(k, h("div", "", element, ...(shared ? [] : [rhoKey(rhos, shade)])))];
  });
  return [...(shared ? [rhoKey(all, shadeOver(all))] : []), h("div", "grid fit", ...out)];
}

/** The systems over each other, each just above its jamming or at its densest, on both kinds of axis. */
function together(context: Context, curves: Curve[][]): HTMLElement {
  const range = ends(curves)!;
  const known = curves.some((_, k) => jammingOf(context.data, k) !== null);
  const linesAt = (densest: boolean): Line[] =>
    curves.flatMap((own, k) => {
      if (!own.length) return [];
      const jamming = jammingOf(context.data, k);
      const above = own.find((c) => jamming !== null && c.rho >= jamming - 1e-9);
      const curve = (densest ? undefined : above) ?? own[own.length - 1];
      const line = context.line(k, curve.x, { mean: curve.mean, se: curve.se });
      return [{ ...line, label: `${line.label}, <i>ρ</i> = ${plain(curve.rho, 3)}`, points: false }];
    });
  const charts = [false, true].map((log) =>
    context.chart({
      ...AXIS,
      title: `<i>P</i>(<i>F</i>/<i>F̄</i>) <span class="what">${log ? "logarithmic" : "linear"} axis</span>`,
      lines: linesAt(true),
      log,
      height: 280,
      yRange: yRange(log, range),
      sync: "force",
    }),
  );
  const ways: [boolean, string][] = [
    [false, `each just above its ${jammingSymbol(context.data)}`],
    [true, "each at its densest"],
  ];
  const buttons = ways.map(([densest, name]) => {
    const button = h("button", "choice", markup(name));
    button.addEventListener("click", () => show(densest));
    return button;
  });
  const show = (densest: boolean) => {
    for (const made of charts) made.replace(linesAt(densest));
    ways.forEach(([way], k) => buttons[k].setAttribute("aria-pressed", String(way === densest)));
  };
  show(true);
  return h("div", "", ...(known ? [h("div", "chooser", ...buttons)] : []), h("div", "grid two", ...charts.map((c) => c.element)));
}

export const forces: Section = {
  id: "forces",
  title: "Distribution of forces",
  build(context) {
    const data = context.data.distribution("force_distribution");
    if (!data) return null;
    const curves = curvesOf(context, data);
    if (!ends(curves)) return null;
    const total = context.data.study.measure.force === "total";
    const what = total ? "contact force" : "normal force";
    const formula = "<i>P</i>(<i>F</i>/<i>F̄</i>), integral 1, averaged over realisations";
    const place = h("div");
    const ways: [boolean, string][] = [
      [true, "logarithmic axis"],
      [false, "linear axis"],
    ];
    const buttons = ways.map(([log, name]) => {
      const button = h("button", "choice", name);
      button.addEventListener("click", () => show(log));
      return button;
    });
    const show = (log: boolean) => {
      place.replaceChildren(...panels(context, curves, log));
      ways.forEach(([way], k) => buttons[k].setAttribute("aria-pressed", String(way === log)));
    };
    show(true);
    const out = [
      figure("", [h("div", "chooser", ...buttons), place], {
        text:
          `Probability density of the ${what} between two grains, in units of its mean; darker curves are denser packings. On a ` +
          "logarithmic axis a straight line is an exponential tail, a curve bending down is closer to a Gaussian. " +
          `Bins are at least ${WIDTH} wide and hold at least ${LEAST} contacts.`,
        formula,
        source: total ? "S2 Sec. 4.1, Fig. 3." : "S1 Sec. III.B, Figs. 9 and 10.",
      }),
    ];
    if (curves.filter((own) => own.length).length > 1)
      out.push(
        figure("", [together(context, curves)], {
          text: `The same distributions, one packing fraction of each system: a wider one means forces that differ more.`,
          formula,
          source: total ? "S2 Sec. 4.1." : undefined,
        }),
      );
    return out;
  },
};
