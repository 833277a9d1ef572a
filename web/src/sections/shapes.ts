// What the grains are: a picture and the numbers of every shape.
import { armsOfShape } from "../clusters";
import type { Context, Section } from "../context";
import type { ShapeFacts } from "../data";
import { figure, h, markup, tableOf } from "../dom";
import { plain } from "../numbers";
import { drawScene } from "../spheres/picture";
import type { Scene } from "../spheres/scene";
import { startLook, startView } from "../spheres/view";
import { paler, systemColour } from "../theme";

const SIZE = 84;

/** One body of size factor 1, alone. */
function sceneOf(shape: ShapeFacts, tint: string): Scene {
  const reach = 0.62 * shape.circumradius;
  return {
    grains: new Float32Array(0),
    strongest: new Float32Array(0),
    contacts: new Float32Array(0),
    arms: armsOfShape(shape),
    unit: 1,
    half: [reach, reach, reach],
    cylinder: null,
    bare: true,
    tint,
    reach: Math.hypot(reach, reach, reach),
  };
}

function icon(shape: ShapeFacts, tint: string): HTMLCanvasElement {
  const canvas = h("canvas");
  canvas.style.width = canvas.style.height = `${SIZE}px`;
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", `a ${shape.name}, L/d = ${plain(shape.aspect)}`);
  drawScene(canvas, sceneOf(shape, tint), SIZE, startView("y"), startLook(true), false, false);
  return canvas;
}

/** Different shapes of the study, round ones first, and the systems that have each. */
function differentShapes(context: Context): ShapeFacts[] {
  const all = (context.data.shapes?.systems ?? []).flatMap((shapes) => shapes ?? []);
  const seen = new Map(all.map((shape) => [JSON.stringify(shape), shape]));
  return [...seen.values()].sort((a, b) => a.name.localeCompare(b.name) || b.sphericity - a.sphericity);
}

/** The colour of the systems of a shape, made lighter, so that its own shade can be seen. */
function colourOf(context: Context, shape: ShapeFacts): string {
  const wanted = JSON.stringify(shape);
  const system = context.data.shapes!.systems.findIndex((shapes) => shapes?.some((one) => JSON.stringify(one) === wanted));
  return paler(systemColour(system), 0.35);
}

/** One number where the three agree. */
function inertia({ name, inertia: [x, y, z], volume }: ShapeFacts): string {
  const parts = [x, y, z].map((v) => plain(v / volume, 4));
  if (new Set(parts).size === 1) return parts[0];
  return name === "cross" ? parts[2] : parts.join(", ");
}

export const shapes: Section = {
  id: "shapes",
  title: "Shapes",
  build(context) {
    const all = differentShapes(context);
    if (!all.length) return null;
    const number = (value: number | null) => (value === null ? "–" : plain(value));
    const rows = all.map((shape) => [
      icon(shape, colourOf(context, shape)),
      shape.name,
      plain(shape.aspect),
      markup(`<b>${plain(shape.sphericity)}</b>`),
      plain(shape.volume),
      plain(shape.surface),
      plain(shape.area),
      inertia(shape),
      ...[shape.d1, shape.d2, shape.d3, shape.name === "star" ? shape.j1 : null].map(number),
    ]);
    const head = [
      "",
      "shape",
      "<i>L</i>/<i>d</i>",
      "sphericity <i>ψ</i>",
      "<i>V</i>/<i>d</i><sup>3</sup>",
      "<i>A</i>/<i>d</i><sup>2</sup>",
      "shadow/<i>d</i><sup>2</sup>",
      "<i>I</i>/<i>md</i><sup>2</sup>",
      "<i>D</i><sub>1</sub>/<i>L</i>",
      "<i>D</i><sub>2</sub>/<i>L</i>",
      "<i>D</i><sub>3</sub>/<i>L</i>",
      "<i>J</i><sub>1</sub>/<i>L</i>",
    ];
    return [
      figure("", [tableOf("numbers shapes", head, rows)], {
        text:
          "The grains: spherocylinders of length <i>L</i> and diameter <i>d</i> joined to rigid bodies; overlap of arms counts " +
          "once. The shadow is the area seen along <i>z</i>, which is what two dimensions see; of a cross, <i>I</i> is about that axis. " +
          "<i>D</i><sub>1</sub> to <i>D</i><sub>3</sub> are distances of neighbours that lie in each other's corners, <i>J</i><sub>1</sub> " +
          "is that of stars nested along the space diagonal.",
        formula:
          "<i>ψ</i> = π<sup>1/3</sup>(6<i>V</i>)<sup>2/3</sup>/<i>A</i>; <i>D</i><sub>1</sub> = [<i>d</i><sup>2</sup> + ((<i>L</i>+<i>d</i>)/2)<sup>2</sup>]<sup>1/2</sup>, " +
          "<i>D</i><sub>n</sub> = <i>n D</i><sub>1</sub>; <i>J</i><sub>1</sub> = √3 <i>d</i>",
        source: "S3 Table 2, Eqs. 11 and 12, Fig. 7. At <i>L</i>/<i>d</i> = 1.1 S3 prints <i>ψ</i> = .995.",
      }),
    ];
  },
};
