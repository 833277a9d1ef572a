// Studies of clusters compare shapes within a kind of container: what a system's kind is, and how shapes are told apart.
import type { Data, Study, System } from "./data";
import { shapeOf } from "./data";
import { escape } from "./dom";
import { plain } from "./numbers";
import { optionSymbol, optionValue } from "./symbols";

/** Options that say what the grains are; the others that differ make the kind. */
const GRAINS = /^grains\./;
/** Told by the name of the container. */
const CONTAINER = ["domain.dimension", "domain.walls", "domain.thickness", "domain.width"];
/** Follow from the rest, and name no kind. */
const DERIVED = ["start.packing_fraction", "integrator.step"];

const number = (system: System, key: string) => Number(system.options[key]);

/** "2D", "slab T = 2 L", "cylinder 10 L": with the width only where that differs between containers of one sort. */
function container(study: Study, system: System): string {
  const width = plain(number(system, "domain.width"));
  const sort = (s: System) => `${s.options["domain.dimension"]} ${s.options["domain.walls"]}`;
  const alike = study.systems.filter((s) => sort(s) === sort(system));
  const widths = new Set(alike.map((s) => s.options["domain.width"])).size > 1;
  const wide = widths ? `, ${width} <i>L</i> wide` : "";
  if (number(system, "domain.dimension") === 2) return `2D${wide}`;
  if (system.options["domain.walls"] === "cylinder") return `cylinder ${width} <i>L</i>`;
  const thickness = number(system, "domain.thickness");
  return `slab <i>T</i> = ${thickness === 1 ? "" : `${plain(thickness)} `}<i>L</i>${wide}`;
}

export interface Kind {
  /** markup */
  label: string;
  dimension: number;
  thickness: number;
  walls: string;
  /** from round to long arms */
  systems: number[];
}

/** The kinds that have systems of known shape, in the order of the study; empty where there are no clusters. */
export function kindsOf(data: Data): Kind[] {
  const { study } = data;
  if (!data.shapes) return [];
  const kinds = new Map<string, Kind>();
  study.systems.forEach((system, k) => {
    if (!shapeOf(data, k)) return;
    const others = study.swept
      .filter((key) => !GRAINS.test(key) && !CONTAINER.includes(key) && !DERIVED.includes(key) && key in system.swept)
      .filter((key) => study.systems.some((s) => s.swept[key] !== system.swept[key]))
      .map((key) => `${optionSymbol(key)} = ${optionValue(system.swept[key])}`);
    const label = [container(study, system), ...others].join(", ");
    const kind = kinds.get(label) ?? {
      label,
      dimension: number(system, "domain.dimension"),
      thickness: number(system, "domain.thickness"),
      walls: String(system.options["domain.walls"]),
      systems: [],
    };
    kind.systems.push(k);
    kinds.set(label, kind);
  });
  const round = (k: number) => -shapeOf(data, k)!.sphericity;
  for (const kind of kinds.values()) kind.systems.sort((a, b) => round(a) - round(b));
  return [...kinds.values()];
}

/** "L/d = 3", or the name of a shape that has no arms of one length. */
export function shapeLabel(data: Data, system: number): string {
  const shape = shapeOf(data, system);
  if (!shape) return escape(data.study.systems[system].name);
  const named = ["cross", "star", "rod"].includes(shape.name);
  return named ? `<i>L</i>/<i>d</i> = ${plain(shape.aspect)}` : escape(`${shape.name}s`);
}

/** Labels of all systems by kind and shape, or null where two would be called the same. */
export function clusterLabels(data: Data): string[] | null {
  const kinds = kindsOf(data);
  if (!kinds.length) return null;
  const labels = data.study.systems.map((system, k) => {
    const kind = kinds.find((one) => one.systems.includes(k));
    if (!kind) return escape(system.name);
    return kinds.length > 1 ? `${kind.label}, ${shapeLabel(data, k)}` : shapeLabel(data, k);
  });
  return new Set(labels).size === labels.length ? labels : null;
}

/** Where each system stands from round (0) to long arms (1), among the sphericities of the study. */
export function shapeRanks(data: Data): (number | null)[] {
  const psi = data.study.systems.map((_, k) => shapeOf(data, k)?.aspect ?? null);
  const known = [...new Set(psi.filter((v) => v !== null))].sort((a, b) => a - b);
  return psi.map((v) => (v === null ? null : known.length > 1 ? known.indexOf(v) / (known.length - 1) : null));
}
