// Rigid clusters of a packing, unpacked for drawing: every arm as a spherocylinder in the coordinates of the packing.
import type { ClusterShape, NetworkFrame } from "./data";
import { words } from "./packed";

/** ends of the axis (x, y, z each), radius, and the stress i = I₁/⟨I₁⟩ of the body */
export const PER_ARM = 8;

/** Weakest and strongest stress that bodies are coloured by; 0 is no contact. */
export const STRONGEST_STRESS = 4;

/** An arm of a shape: centre, direction, half length, radius. */
type Arm = number[];
type Quaternion = [number, number, number, number];

function turned([w, x, y, z]: Quaternion, [a, b, c]: number[]): [number, number, number] {
  const [tx, ty, tz] = [2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)];
  return [a + w * tx + y * tz - z * ty, b + w * ty + z * tx - x * tz, c + w * tz + x * ty - y * tx];
}

/** Writes an arm of a body at `place` into `out`, as the number `index`. */
function put(out: Float32Array, index: number, arm: Arm, q: Quaternion, scale: number, place: number[], stress: number): void {
  const centre = turned(q, arm.slice(0, 3));
  const along = turned(q, arm.slice(3, 6));
  for (let a = 0; a < 3; ++a) {
    const middle = place[a] + scale * centre[a];
    const reach = scale * arm[6] * along[a];
    out[PER_ARM * index + a] = middle - reach;
    out[PER_ARM * index + 3 + a] = middle + reach;
  }
  out[PER_ARM * index + 6] = scale * arm[7];
  out[PER_ARM * index + 7] = stress;
}

/** The arms of a shape in its own frame. */
export function armsOfShape(shape: ClusterShape): Float32Array {
  const out = new Float32Array(PER_ARM * shape.arms.length);
  shape.arms.forEach((arm, k) => put(out, k, arm, [1, 0, 0, 0], 1, [0, 0, 0], 1));
  return out;
}

/** All arms of a packing of clusters, body by body, about `middle`. */
export function armsOf(frame: NetworkFrame, middle: number[]): Float32Array {
  const { shapes, shape, orientation, stress, stress_max } = frame.clusters!;
  const kind = shape ? words(shape) : null;
  const turns = orientation.map(words);
  const stresses = words(stress);
  const radius = words(frame.radius);
  const axes = frame.axes.map(words);
  const count = kind
    ? kind.reduce((sum, k) => sum + shapes[k].arms.length, 0)
    : frame.grains * shapes[0].arms.length;
  const out = new Float32Array(PER_ARM * count);
  const part = (word: number) => (2 * word) / 65535 - 1;
  let next = 0;
  for (let g = 0; g < frame.grains; ++g) {
    const own = shapes[kind ? kind[g] : 0];
    const scale = ((radius[g] / 65535) * frame.radius_max) / own.circumradius;
    const parts = turns.map((turn) => part(turn[g]));
    const q = (parts.length === 2 ? [parts[0], 0, 0, parts[1]] : parts) as Quaternion;
    const length = Math.hypot(...q) || 1;
    const unit = q.map((v) => v / length) as Quaternion;
    const place = [0, 1, 2].map((a) => (axes[a] ? positionOf(frame, axes[a][g], a) - middle[a] : 0));
    for (const arm of own.arms) put(out, next++, arm, unit, scale, place, (stresses[g] / 65535) * stress_max);
  }
  return out;
}

/** A coordinate that was quantised between the corners of the picture and a margin around them. */
export function positionOf(frame: NetworkFrame, word: number, axis: number): number {
  const side = frame.upper[axis] - frame.lower[axis];
  return frame.lower[axis] + (word / 65535) * (side + 2 * frame.margin) - frame.margin;
}

/** Width of force lines: mean diameters of grains, and more between long arms, whose centres lie far apart. */
export function lineUnit(frame: NetworkFrame): number {
  if (!frame.clusters) return 1;
  return Math.max(1, 0.6 * Math.max(...frame.clusters.shapes.map((shape) => shape.length)));
}
