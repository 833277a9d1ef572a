// Title, one line of facts, one picture, and the way to the sections.
import type { Context } from "./context";
import type { Study } from "./data";
import { jammingOf } from "./data";
import { h, markup } from "./dom";
import { plain } from "./numbers";
import { drawPacking } from "./packing";
import { drawSpheres } from "./spheres/picture";
import { START_LOOK, startView } from "./spheres/view";
import { pick } from "./frame_choice";

function facts(study: Study): string[] {
  const runs = study.systems.reduce((sum, s) => sum + s.realisations, 0);
  const counts = [...new Set(study.systems.map((s) => s.options["grains.count"]))].filter((n) => n !== undefined);
  const dimensions = [...new Set(study.systems.map((s) => s.options["domain.dimension"]))].filter((n) => n !== undefined);
  return [
    `${study.systems.length} system${study.systems.length === 1 ? "" : "s"}`,
    `${runs} realisation${runs === 1 ? "" : "s"}`,
    ...(counts.length ? [`${counts.join(" or ")} grains each`] : []),
    ...(dimensions.length ? [`${dimensions.join(" and ")} dimensions`] : []),
  ];
}

/** The network of the last system that has one, where it has just jammed. */
function emblem(context: Context): HTMLElement | null {
  const systems = context.data.networks?.systems ?? [];
  for (let system = systems.length - 1; system >= 0; --system) {
    const frame = pick(systems[system], "own", jammingOf(context.data, system));
    if (!frame) continue;
    const size = 300;
    const canvas = h("canvas");
    canvas.style.width = canvas.style.height = `${size}px`;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", "force network of one packing");
    if (frame.axes.length === 3) drawSpheres(canvas, frame, size, startView(), START_LOOK);
    else drawPacking(canvas, frame, size);
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
