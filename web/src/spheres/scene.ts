// One packing of spheres or clusters, unpacked for drawing: coordinates from the middle of the box, in mean diameters.
import { armsOf, lineUnit, positionOf } from "../clusters";
import type { NetworkFrame } from "../data";
import { longs, words } from "../packed";

export interface Scene {
  /** x, y, z, radius per grain; empty for clusters */
  grains: Float32Array;
  /** per grain: the largest force at one of its contacts, in mean forces; −1 with fewer than two contacts */
  strongest: Float32Array;
  /** x, y, z of both ends and the force, per contact; weak ones first */
  contacts: Float32Array;
  /** clusters: their arms (clusters.ts); else empty, and there are grains */
  arms: Float32Array;
  /** width of force lines, in diameters */
  unit: number;
  /** half the sides of the box */
  half: [number, number, number];
  /** an upright cylinder in place of the box */
  cylinder: { axis: number; centre: number[]; radius: number } | null;
  /** of a ball about the middle that holds the box */
  reach: number;
  /** nothing stands around it */
  bare?: boolean;
  /** colour of all arms, in place of their stress */
  tint?: string;
}

export const PER_GRAIN = 4;
export const PER_CONTACT = 7;

const scenes = new WeakMap<NetworkFrame, Scene>();

export function sceneOf(frame: NetworkFrame): Scene {
  let scene = scenes.get(frame);
  if (!scene) scenes.set(frame, (scene = unpack(frame)));
  return scene;
}

function unpack(frame: NetworkFrame): Scene {
  const half = [0, 1, 2].map((a) => (frame.upper[a] - frame.lower[a]) / 2) as Scene["half"];
  const axes = frame.axes.map(words);
  const radii = words(frame.radius);
  const middle = half.map((side, a) => frame.lower[a] + side);
  const at = (node: number, axis: number) => positionOf(frame, axes[axis][node], axis) - middle[axis];

  const balls = frame.clusters ? 0 : frame.grains;
  const grains = new Float32Array(PER_GRAIN * balls);
  for (let g = 0; g < balls; ++g) {
    for (let a = 0; a < 3; ++a) grains[PER_GRAIN * g + a] = at(g, a);
    grains[PER_GRAIN * g + 3] = (radii[g] / 65535) * frame.radius_max;
  }

  const pairs = frame.nodes > 65535 ? longs(frame.pairs) : words(frame.pairs);
  const force = words(frame.force);
  const order = Array.from(force.keys()).sort((a, b) => force[a] - force[b]);
  const contacts = new Float32Array(PER_CONTACT * frame.contacts);
  const strongest = new Float32Array(frame.grains);
  const touches = new Uint16Array(frame.nodes);
  order.forEach((c, k) => {
    const value = (force[c] / 65535) * frame.force_max;
    for (const end of [0, 1]) {
      const node = pairs[2 * c + end];
      for (let a = 0; a < 3; ++a) contacts[PER_CONTACT * k + 3 * end + a] = at(node, a);
      touches[node] += 1;
      if (node < frame.grains) strongest[node] = Math.max(strongest[node], value);
    }
    contacts[PER_CONTACT * k + 6] = value;
  });
  for (let g = 0; g < frame.grains; ++g) if (touches[g] < 2) strongest[g] = -1;
  const arms = frame.clusters ? armsOf(frame, middle) : new Float32Array(0);
  const round = frame.clusters?.cylinder ?? null;
  const cylinder = round && { ...round, centre: round.centre.map((c, a) => c - middle[a]) };
  return { grains, strongest, contacts, arms, unit: lineUnit(frame), half, cylinder, reach: Math.hypot(...half) };
}
