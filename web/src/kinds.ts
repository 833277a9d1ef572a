// Studies of clusters compare shapes within a kind of container: what a system's kind is, and how shapes are told apart.
import type { Data, Study, System } from "./data";
import { shapeOf } from "./data";
import { escape } from "./dom";
import { plain } from "./numbers";
import { optionSymbol, optionValue } from "./symbols";
import { systemDash } from "./theme";

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

/** Options that tell apart systems of one shape in one sort of container; of several that go together the first. */
function othersOf(data: Data): string[] {
  const known = others.get(data) ?? findOthers(data);
  others.set(data, known);
  return known;
}

const others = new WeakMap<Data, string[]>();

function findOthers(data: Data): string[] {
  const { study } = data;
  const keys = study.swept.filter((key) => !GRAINS.test(key) && !CONTAINER.includes(key) && !DERIVED.includes(key));
  const kept: string[] = [];
  const known = study.systems.map((system, k) => [container(study, system), JSON.stringify(shapeOf(data, k)?.arms)]);
  for (const key of keys) {
    const seen = new Map<string, unknown>();
    const differs = study.systems.some((system, k) => {
      const rest = JSON.stringify([...known[k], ...kept.map((one) => system.swept[one])]);
      const before = seen.has(rest) && seen.get(rest) !== system.swept[key];
      seen.set(rest, system.swept[key]);
      return before;
    });
    if (differs) kept.push(key);
  }
  return kept;
}

/** The values of these options; empty where there are none. */
function othersLabel(data: Data, system: number): string {
  const { swept } = data.study.systems[system];
  return othersOf(data)
    .filter((key) => key in swept)
    .map((key) => `${optionSymbol(key)} = ${optionValue(swept[key])}`)
    .join(", ");
}

export interface Kind {
  /** markup */
  label: string;
  dimension: number;
  walls: string;
  /** from round to long arms */
  systems: number[];
}

/** Systems of known shape sorted by a label, in the order of the study; empty where there are no clusters. */
function sorted(data: Data, labelOf: (system: number) => string): Kind[] {
  const kinds = new Map<string, Kind>();
  data.study.systems.forEach((system, k) => {
    if (!shapeOf(data, k)) return;
    const label = labelOf(k);
    const kind = kinds.get(label) ?? {
      label,
      dimension: number(system, "domain.dimension"),
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

const containerLabel = (data: Data, system: number) => container(data.study, data.study.systems[system]);

/** Of one container, in a panel of its own. */
export function containersOf(data: Data): Kind[] {
  return sorted(data, (k) => containerLabel(data, k));
}

/** What differs in nothing but the shape. */
export function kindsOf(data: Data): Kind[] {
  return sorted(data, (k) => [containerLabel(data, k), othersLabel(data, k)].filter(Boolean).join(", "));
}

/** "L/d = 3", or the name of a shape that has no arms of one length. */
export function shapeLabel(data: Data, system: number): string {
  const shape = shapeOf(data, system);
  if (!shape) return escape(data.study.systems[system].name);
  const named = ["cross", "star", "rod"].includes(shape.name);
  if (!named && shape.name === "custom") return escape(data.study.systems[system].name);
  return named ? `<i>L</i>/<i>d</i> = ${plain(shape.aspect)}` : escape(`${shape.name}s`);
}

/** What tells a system from others in the same container. */
export function curveLabel(data: Data, system: number): string {
  return [shapeLabel(data, system), othersLabel(data, system)].filter(Boolean).join(", ");
}

/** Kinds of line, by system: for the options that differ, or for the container where none does. */
export function dashesOf(data: Data): number[] {
  const labels = data.study.systems.map((_, k) => othersLabel(data, k));
  const names = new Set(labels).size > 1 ? labels : data.study.systems.map((_, k) => containerLabel(data, k));
  const different = [...new Set(names)];
  return names.map((name) => different.indexOf(name));
}

/** Of the curves in one panel. */
export function panelDash(data: Data, system: number): number[] | undefined {
  return othersOf(data).length ? systemDash(system) : undefined;
}

/** What the kinds of line in a panel mean, in their order; empty where there is one. */
export function dashLabels(data: Data): string[] {
  return othersOf(data).length ? [...new Set(data.study.systems.map((_, k) => othersLabel(data, k)))] : [];
}

/** Labels of all systems by kind and shape, or null where two would be called the same. */
export function clusterLabels(data: Data): string[] | null {
  if (!data.shapes) return null;
  const containers = containersOf(data).length;
  const labels = data.study.systems.map((system, k) => {
    if (!shapeOf(data, k)) return escape(system.name);
    return containers > 1 ? `${containerLabel(data, k)}, ${curveLabel(data, k)}` : curveLabel(data, k);
  });
  return new Set(labels).size === labels.length ? labels : null;
}

/** Where each system stands from round (0) to long arms (1), among the sphericities of the study. */
export function shapeRanks(data: Data): (number | null)[] {
  const psi = data.study.systems.map((_, k) => shapeOf(data, k)?.aspect ?? null);
  const known = [...new Set(psi.filter((v) => v !== null))].sort((a, b) => a - b);
  return psi.map((v) => (v === null ? null : known.length > 1 ? known.indexOf(v) / (known.length - 1) : null));
}
