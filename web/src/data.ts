// What the program wrote into the page: one JSON block per idea, absent when the study has no such result.

export interface System {
  name: string;
  /** options that differ between the systems of the study, by key */
  swept: Record<string, number | string>;
  /** all options known, by key */
  options: Record<string, number | string>;
  realisations: number;
  planned: number | null;
}

export interface Study {
  title: string;
  name: string;
  program: string;
  revision: string;
  seed: string;
  swept: string[];
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
  systems: { rho: number[]; quantities: Record<string, Estimate> }[];
}

/** blocks named after measures with several rows a frame (force_distribution, pair_correlation, betti) */
export interface Distribution {
  systems: { frames: { rho: number; x: number[]; quantities: Record<string, Estimate> }[] }[];
}

/** block "columns": what a column of ensemble/frames.csv means */
export type Columns = Record<string, { text: string; unit: string; formula: string; source: string }>;

export interface Transitions {
  rows: { system: number; quantity: string; n: number; value: number; se: number | null }[];
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
  /** published rho_c */
  published: { system: number; value: number }[];
}

/** One packing: nodes are grains, then beads of walls, then foot points of walls and ghosts of periodic neighbours. */
export interface NetworkFrame {
  rho: number;
  /** only there because it is the first above the rho_c of its system */
  own?: boolean;
  realisation: number;
  /** x and y of the lower and upper corner of the picture */
  extent: [number, number, number, number];
  /** x and y of the lower and upper corner between which positions are quantised */
  range: [number, number, number, number];
  grains: number;
  beads: number;
  nodes: number;
  /** uint16 x and y per node over the range; uint16 radius per node over radius_max */
  x: string;
  y: string;
  radius: string;
  radius_max: number;
  contacts: number;
  /** uint16 or uint32 (nodes > 65535) pairs; uint16 force over force_max, in mean grain-grain normal forces */
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
    score: block("score"),
    networks: block("networks"),
    diagrams: block("diagrams"),
    distribution: (measure) => block(`many-${measure}`),
  };
}

/** rho_c of a system as the study counts it (Z = 3), or null. */
export function rhoC(data: Data, system: number): number | null {
  return data.transitions?.rows.find((r) => r.system === system && r.quantity === "rho_c")?.value ?? null;
}
