// One packing of spheres, unpacked for drawing: coordinates from the middle of the box, in mean grain diameters.
import type { NetworkFrame } from "../data";
import { longs, words } from "../packed";

export interface Scene {
  /** x, y, z, radius per grain */
  grains: Float32Array;
  /** per grain: the largest force at one of its contacts, in mean forces; −1 with fewer than two contacts */
  strongest: Float32Array;
  /** x, y, z of both ends and the force, per contact; weak ones first */
  contacts: Float32Array;
  /** half the sides of the box */
  half: [number, number, number];
  /** of a ball about the middle that holds the box */
  reach: number;
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
  const at = (node: number, axis: number) => (axes[axis][node] / 65535) * 2 * (half[axis] + frame.margin) - half[axis] - frame.margin;

  const grains = new Float32Array(PER_GRAIN * frame.grains);
  for (let g = 0; g < frame.grains; ++g) {
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
  return { grains, strongest, contacts, half, reach: Math.hypot(...half) };
}
