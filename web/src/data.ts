// What the program wrote into the page: one JSON block per idea, absent when the study has no such result.

export interface System {
  name: string;
  /** options that differ between the systems of the study, by key */
  swept: Record<string, number | string>;
  /** all options known, by key */
  options: Record<string, number | string>;
  realisations: number;
  planned: number | null;
  /** d, m and tau_c in m, kg and s; null in a study of scaled units */
  scales?: { length: number; mass: number; time: number } | null;
  /** how the relaxations before its frames ended, over all realisations; null where nothing relaxes */
  relaxations?: { fluctuation: number; energy: number; budget: number } | null;
}

export interface Study {
  title: string;
  name: string;
  program: string;
  revision: string;
  seed: string;
  swept: string[];
  /** what is the weight of an edge, and the largest kept (0: all) */
  measure: { force: "normal" | "total"; clamp: number };
  systems: System[];
}

type Numbers = (number | null)[];

/** mean and standard error of one quantity; se is null where there is a single realisation */
export interface Estimate {
  mean: Numbers;
  se: Numbers;
}

/** block "frames": per system, every column of ensemble/frames.csv over packing fraction */
export interface Frames {
  /** unrelaxed: per packing fraction, how many realisations were not relaxed; absent where nothing relaxes */
  systems: { rho: number[]; unrelaxed?: number[]; quantities: Record<string, Estimate> }[];
}

/** block "surfaces": quantities over packing fraction and force threshold; row by row, a row per packing fraction */
export interface Surfaces {
  systems: { rho: number[]; thresholds: number[]; unrelaxed?: number[]; quantities: Record<string, Estimate> }[];
}

/** blocks named after measures with several rows a frame (force_distribution, pair_correlation, betti) */
export interface Distribution {
  systems: { frames: { rho: number; x: number[]; quantities: Record<string, Estimate> }[] }[];
}

/** block "columns": what a column of ensemble/frames.csv means */
export type Columns = Record<string, { text: string; unit: string; formula: string; source: string }>;

export interface Transitions {
  rows: { system: number; quantity: string; n: number; value: number; se: number | null }[];
  /** per system, where the report says it jams, and which quantity that is */
  jamming: ({ rho: number; quantity: string } | null)[];
}

export type Verdict = "pass" | "fail" | "known deviation" | "insufficient";

/** block "score": published values and orders beside ours */
export interface Score {
  rows: {
    target: string;
    source: string;
    systems: string;
    published: string;
    ours: number | null;
    error: number | null;
    n: number;
    needed: number;
    verdict: Verdict;
    note: string;
  }[];
  /** published points of jamming */
  published: { system: number; value: number }[];
}

/** One packing: nodes are grains, then beads of walls, then points where a line ends at a wall or a periodic border. */
export interface NetworkFrame {
  rho: number;
  /** only there because it is the first where its system is jammed */
  own?: boolean;
  realisation: number;
  /** corners of the picture, two or three coordinates */
  lower: number[];
  upper: number[];
  /** positions are quantised between the corners and this much around them */
  margin: number;
  grains: number;
  beads: number;
  nodes: number;
  /** per axis: uint16 coordinate per node; uint16 radius per node over radius_max */
  axes: string[];
  radius: string;
  radius_max: number;
  contacts: number;
  /** uint16 or uint32 (nodes > 65535) pairs; uint16 force over force_max, in mean forces between grains */
  pairs: string;
  force: string;
  force_max: number;
}

export interface Networks {
  systems: NetworkFrame[][];
}

export interface DiagramFrame {
  rho: number;
  own?: boolean;
  realisation: number;
  /** per dimension: uint16 birth, death per pair over value_max; one byte per pair: 1 = never dies */
  dimensions: { pairs: number; values: string; essential: string }[];
  value_max: number;
}

export interface Diagrams {
  systems: DiagramFrame[][];
}

export function block<T>(id: string): T | null {
  const element = document.getElementById(`data-${id}`);
  return element ? (JSON.parse(element.textContent ?? "") as T) : null;
}

export interface Data {
  study: Study;
  frames: Frames | null;
  columns: Columns | null;
  transitions: Transitions | null;
  surfaces: Surfaces | null;
  score: Score | null;
  networks: Networks | null;
  diagrams: Diagrams | null;
  distribution: (measure: string) => Distribution | null;
}

export function load(): Data {
  const study = block<Study>("study");
  if (!study) throw new Error("the page holds no study");
  return {
    study,
    frames: block("frames"),
    columns: block("columns"),
    transitions: block("transitions"),
    surfaces: block("surfaces"),
    score: block("score"),
    networks: block("networks"),
    diagrams: block("diagrams"),
    distribution: (measure) => block(`many-${measure}`),
  };
}

/** Where a system jams, or null. */
export function jammingOf(data: Data, system: number): number | null {
  return data.transitions?.jamming[system]?.rho ?? null;
}

/** The sign of that point: rho_c where Z crosses 3 (S1), rho_J where Z(rho) has its inflection (S2). */
export function jammingSymbol(data: Data): string {
  const crossing = data.transitions?.jamming.some((point) => point?.quantity === "rho_c");
  return `<i>ρ</i><sub>${crossing ? "c" : "J"}</sub>`;
}

/** Grains of a system; 1 where they are not known. */
export function grainsOf(study: Study, system: number): number {
  return Number(study.systems[system].options["grains.count"] ?? 1);
}

export function dimensionOf(study: Study, system: number): number {
  return Number(study.systems[system].options["domain.dimension"] ?? 2);
}
