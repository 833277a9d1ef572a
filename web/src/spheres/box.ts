// What stands around a packing: the edges of its box, or the outline of its cylinder; and the names of the axes.
import { FONT, INK, MUTED } from "../theme";
import type { Scene } from "./scene";
import { rotate, type View } from "./view";

type Point = [number, number, number];
type Segment = [Point, Point];

export function outline(scene: Scene): Segment[] {
  if (scene.bare) return [];
  return scene.cylinder ? cylinderLines(scene) : boxEdges(scene);
}

/** Radius of these lines; those of a high container are no thicker than those of a low one as wide. */
export const fineLine = (scene: Scene): number => 0.0026 * Math.min(scene.reach, 2.4 * scene.half[0]);

/** The twelve edges; four of a box without thickness. */
function boxEdges(scene: Scene): Segment[] {
  const edges: Segment[] = [];
  for (let axis = 0; axis < 3; ++axis)
    for (const u of [-1, 1])
      for (const v of [-1, 1]) {
        const ends = [-1, 1].map((side) => {
          const point: Point = [0, 0, 0];
          point[axis] = side * scene.half[axis];
          point[(axis + 1) % 3] = u * scene.half[(axis + 1) % 3];
          point[(axis + 2) % 3] = v * scene.half[(axis + 2) % 3];
          return point;
        });
        edges.push([ends[0], ends[1]]);
      }
  return edges;
}

const AROUND = 60;
const UPRIGHT = 6;

/** The circles at its two ends, and lines between them. */
function cylinderLines(scene: Scene): Segment[] {
  const { axis, centre, radius } = scene.cylinder!;
  const point = (k: number, side: number): Point => {
    const out: Point = [0, 0, 0];
    const angle = (2 * Math.PI * k) / AROUND;
    out[axis] = side * scene.half[axis];
    out[(axis + 1) % 3] = centre[(axis + 1) % 3] + radius * Math.cos(angle);
    out[(axis + 2) % 3] = centre[(axis + 2) % 3] + radius * Math.sin(angle);
    return out;
  };
  const lines: Segment[] = [];
  for (const side of [-1, 1]) for (let k = 0; k < AROUND; ++k) lines.push([point(k, side), point(k + 1, side)]);
  for (let k = 0; k < AROUND; k += AROUND / UPRIGHT) lines.push([point(k, -1), point(k, 1)]);
  return lines;
}

/** Three arrows in the lower left corner of a picture so high; `unit` is one pixel of the page. */
export function drawAxes(ctx: CanvasRenderingContext2D, height: number, unit: number, view: View): void {
  const length = 24 * unit;
  const [x0, y0] = [36 * unit, height - 36 * unit];
  const arrows = ["x", "y", "z"].map((name, axis) => {
    const unitVector = [0, 0, 0];
    unitVector[axis] = 1;
    return { name, way: rotate(view.rotation, unitVector[0], unitVector[1], unitVector[2]) };
  });
  ctx.save();
  // On a pale ground of their own, so that they can be read before a packing that fills the picture.
  ctx.fillStyle = "rgba(255,255,255,0.72)";
  ctx.beginPath();
  ctx.arc(x0, y0, 38 * unit, 0, 2 * Math.PI);
  ctx.fill();
  ctx.lineWidth = 1.5 * unit;
  ctx.lineCap = "round";
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  ctx.font = `italic ${13 * unit}px "STIX Two Text", Cambria, Georgia, "Times New Roman", serif, ${FONT}`;
  for (const { name, way } of arrows.sort((a, b) => a.way[2] - b.way[2])) {
    const [x, y] = [x0 + way[0] * length, y0 - way[1] * length];
    ctx.strokeStyle = MUTED;
    ctx.beginPath();
    ctx.moveTo(x0, y0);
    ctx.lineTo(x, y);
    ctx.stroke();
    ctx.fillStyle = INK;
    ctx.fillText(name, x0 + way[0] * (length + 9 * unit), y0 - way[1] * (length + 9 * unit));
  }
  ctx.restore();
}
