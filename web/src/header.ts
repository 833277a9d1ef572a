// Title, one line of facts, one picture, and the way to the sections.
import type { Context } from "./context";
import type { Study } from "./data";
import { jammingOf } from "./data";
import { h, markup } from "./dom";
import { plain } from "./numbers";
import { drawPacking, packingAspect } from "./packing";
import { drawSpheres, spheresAspect } from "./spheres/picture";
import { startLook } from "./spheres/view";
import { pick } from "./frame_choice";

/** A few numbers, or from where to where many go. */
function spread(values: number[]): string {
  return values.length > 3 ? `${Math.min(...values)} to ${Math.max(...values)}` : values.join(" or ");
}

function facts(study: Study): string[] {
  const runs = study.systems.reduce((sum, s) => sum + s.realisations, 0);
  const counts = [...new Set(study.systems.map((s) => s.options["grains.count"]))].filter((n) => n !== undefined);
  const dimensions = [...new Set(study.systems.map((s) => s.options["domain.dimension"]))].filter((n) => n !== undefined);
  return [
    `${study.systems.length} system${study.systems.length === 1 ? "" : "s"}`,
    `${runs} realisation${runs === 1 ? "" : "s"}`,
    ...(counts.length ? [`${spread(counts.map(Number))} grains each`] : []),
    ...(dimensions.length ? [`${dimensions.join(" and ")} dimensions`] : []),
  ];
}

/** The network of the last system that has one, where it has just jammed. */
function emblem(context: Context): HTMLElement | null {
  const systems = context.data.networks?.systems ?? [];
  for (let system = systems.length - 1; system >= 0; --system) {
    const frame = pick(systems[system], "own", jammingOf(context.data, system));
    if (!frame) continue;
    const canvas = h("canvas");
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", "force network of one packing");
    const three = frame.axes.length === 3;
    const look = startLook(frame.clusters !== undefined);
    const aspect = three ? spheresAspect(frame) : packingAspect(frame);
    const size = Math.round(Math.min(300, 330 / aspect));
    canvas.style.width = `${size}px`;
    canvas.style.height = `${size * aspect}px`;
    if (three) drawSpheres(canvas, frame, size, context.state.start, look);
    else drawPacking(canvas, frame, size, look);
    const text = `${context.labels[system]}, <i>ρ</i> = ${plain(frame.rho, 3)}`;
    return h("div", "emblem", canvas, markup(text, "div", "emblem-text"));
  }
  return null;
}

export function header(context: Context, links: HTMLElement[]): HTMLElement {
  const { study } = context.data;
  const line = h("p", "facts", ...facts(study).map((fact) => h("span", "", fact)));
  const origin = [
    `study ${study.name}`,
    study.seed && `seed ${study.seed}`,
    study.program,
    study.revision && `revision ${study.revision}`,
  ].filter(Boolean);
  const words = h("div", "words", h("p", "origin", origin.join("  ·  ")), h("h1", "", study.title), line, h("nav", "", ...links));
  return h("header", "", words, emblem(context));
}
