// From where a packing is seen. All pictures of the page share one view, so that they can be compared.
import type { Scene } from "./scene";

/** Rows are the screen's x, y and the direction towards the reader, in the packing's axes. */
export type Rotation = [number, number, number, number, number, number, number, number, number];

export interface View {
  rotation: Rotation;
  zoom: number;
}

/** What is drawn of a packing. */
export interface Look {
  what: "forces" | "both" | "grains";
  /** weakest force drawn, in mean forces */
  least: number;
  /** part of the packing cut away in front, 0 to 1 */
  cut: number;
}

/** Clusters show their stress at first. */
export function startLook(clusters: boolean): Look {
  return { what: clusters ? "grains" : "both", least: 0, cut: 0 };
}

/** Distance of the eye from the middle, in units of the scene's reach. */
export const EYE = 4.5;

/** Size of that ball in a picture from −1 to 1: a box does not reach its border in most views. */
const FIT = 1.06;

/** The axis that points up on the screen at first: y in containers, where gravity acts along it. */
export type Upright = "y" | "z";

export function startView(upright: Upright): View {
  const straight: Rotation = upright === "y" ? [1, 0, 0, 0, 1, 0, 0, 0, 1] : [1, 0, 0, 0, 0, 1, 0, -1, 0];
  return { rotation: turned(turned(straight, 0.55, 0), 0, 0.3), zoom: 1 };
}

/** Turned about the screen's upright axis, and then about its horizontal one, by angles in radians. */
export function turned(r: Rotation, yaw: number, pitch: number): Rotation {
  const [cy, sy, cp, sp] = [Math.cos(yaw), Math.sin(yaw), Math.cos(pitch), Math.sin(pitch)];
  const [x, y, z] = [r.slice(0, 3), r.slice(3, 6), r.slice(6, 9)];
  const x1 = x.map((v, k) => cy * v + sy * z[k]);
  const z1 = x.map((v, k) => -sy * v + cy * z[k]);
  const y2 = y.map((v, k) => cp * v - sp * z1[k]);
  const z2 = y.map((v, k) => sp * v + cp * z1[k]);
  return orthonormal([...x1, ...y2, ...z2] as Rotation);
}

/** Many small turns would shear it. */
function orthonormal(r: Rotation): Rotation {
  const unit = (v: number[]) => v.map((c) => c / Math.hypot(...v));
  const x = unit(r.slice(0, 3));
  const y = r.slice(3, 6);
  const along = y.reduce((sum, c, k) => sum + c * x[k], 0);
  const u = unit(y.map((c, k) => c - along * x[k]));
  const z = [x[1] * u[2] - x[2] * u[1], x[2] * u[0] - x[0] * u[2], x[0] * u[1] - x[1] * u[0]];
  return [...x, ...u, ...z] as Rotation;
}

/** How many times a picture of the scene is higher than it is wide. */
export function aspectOf(scene: Scene): number {
  if (!scene.arms.length || scene.bare) return 1;
  const across = scene.cylinder?.radius ?? Math.hypot(scene.half[0], scene.half[2]);
  return Math.min(Math.max(scene.half[1] / across, 1), 1.7);
}

/** The numbers of a perspective that shows all of a scene in a square picture from −1 to 1. */
export interface Lens {
  /** distance of the eye */
  eye: number;
  /** picture coordinate = scale · x / (eye − z) */
  scale: number;
  /** nothing nearer to the eye than this is drawn (by z, towards the reader) */
  front: number;
}

export function lensOf(scene: Scene, view: View, look: Look): Lens {
  const eye = EYE * scene.reach;
  const grazing = Math.sqrt(EYE * EYE - 1); // of the eye's ray that touches the ball of the scene
  return { eye, scale: FIT * grazing * view.zoom, front: scene.reach * (1 - 2 * look.cut) + (look.cut ? 0 : scene.reach) };
}

/** Into the screen's axes. */
export function rotate(r: Rotation, x: number, y: number, z: number): [number, number, number] {
  return [r[0] * x + r[1] * y + r[2] * z, r[3] * x + r[4] * y + r[5] * z, r[6] * x + r[7] * y + r[8] * z];
}
