// Symbols of options and quantities, as markup. What has none is shown by its key.
import type { Study, System } from "./data";
import { escape } from "./dom";
import { plain } from "./numbers";

const OPTIONS: Record<string, string> = {
  "grains.count": "<i>N</i>",
  "grains.width": "<i>r</i><sub>p</sub>",
  "grains.sizes": "sizes",
  "grains.size_ratio": "size ratio",
  "contact.friction": "<i>μ</i>",
  "contact.wall_friction": "<i>μ</i><sub>w</sub>",
  "contact.restitution": "<i>e</i><sub>n</sub>",
  "contact.stiffness": "<i>k</i><sub>n</sub>",
  "contact.tangential_stiffness": "<i>k</i><sub>t</sub>/<i>k</i><sub>n</sub>",
  "domain.dimension": "dimension",
  "domain.walls": "walls",
  "domain.width": "width/<i>L</i>",
  "domain.thickness": "<i>T</i>/<i>L</i>",
  "domain.gravity": "<i>g</i>",
  "grains.shape": "shape",
  "grains.aspect": "<i>L</i>/<i>d</i>",
  "grains.density": "density",
  "contact.law": "force law",
  "start.packing_fraction": "<i>ρ</i> at start",
  "grains.inertia_factor": "<i>I</i>/<i>mR</i><sup>2</sup>",
  "integrator.step": "Δ<i>t</i>",
};

export function optionSymbol(key: string): string {
  const [, stage, option] = /^stage\.(.*)\.(\w+)$/.exec(key) ?? [];
  if (stage) return `${escape(option)} <small>${escape(stage)}</small>`;
  return OPTIONS[key] ?? escape(key.split(".").pop() ?? key);
}

export function optionValue(value: number | string): string {
  return typeof value === "number" ? plain(value) : escape(value);
}

/** A label of more options than these is none. */
const MOST = 3;

/** What tells a system from the others of its study: "r_p = .4, μ = .2", else its name. */
export function systemLabel(study: Study, system: System): string {
  const parts = study.swept
    .filter((key) => key in system.swept)
    .map((key) => `${optionSymbol(key)} = ${optionValue(system.swept[key])}`);
  const shared = study.systems.some((other) => other !== system && sameSwept(study, other, system));
  return parts.length && parts.length <= MOST && !shared ? parts.join(", ") : escape(system.name);
}

function sameSwept(study: Study, a: System, b: System): boolean {
  return study.swept.every((key) => a.swept[key] === b.swept[key]);
}
