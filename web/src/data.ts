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
  /** frames whose energy ledger is off, over all realisations; null where there are none */
  ledger?: { frames: number; from: number; worst: number } | null;
}

export interface Study {
  title: string;
  name: string;
  program: string;
  revision: string;
  seed: string;
  swept: string[];
  /** a frame is marked where its ledger is off by more than `mark`; open: means take such frames in */
  ledger?: { mark: number; open: boolean };
  /** what is the weight of an edge, the largest kept (0: all), whether a lifetime of exactly 0.1 is rough */
  measure: { force: "normal" | "total"; clamp: number; rough_includes_edge?: boolean };
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
  /** unrelaxed: per packing fraction, how many realisations were not relaxed; absent where nothing relaxes.
   * marked: of how many the energy ledger is off; absent where there are none */
  systems: { rho: number[]; unrelaxed?: number[]; marked?: number[]; quantities: Record<string, Estimate> }[];
}

/** block "surfaces": quantities over packing fraction and force threshold; row by row, a row per packing fraction */
export interface Surfaces {
  systems: { rho: number[]; thresholds: number[]; unrelaxed?: number[]; quantities: Record<string, Estimate> }[];
}

/** blocks named after measures with several rows a frame, over packing fraction (force_distribution, pair_correlation, betti) */
export interface Distribution {
  systems: { frames: { rho: number; x: number[]; quantities: Record<string, Estimate> }[] }[];
}

/** such blocks of the final state only: one frame a system, or none (contact_force_distribution, stress_distribution,
 * radial_distribution) */
export interface FinalDistribution {
  systems: { frames: { x: number[]; quantities: Record<string, Estimate> }[] }[];
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

/** For size factor 1: of each arm centre, direction, half length and radius; circumscribed radius and length L. */
export interface ClusterShape {
  arms: number[][];
  circumradius: number;
  length: number;
}

/** What a packing of clusters has beside its nodes, whose radius is that of the circumscribed sphere. */
export interface Clusters {
  shapes: ClusterShape[];
  /** uint16 index of the shape per grain; absent where all have the first */
  shape?: string;
  /** uint16 in [-1, 1] per grain: w, x, y, z of a unit quaternion; in two dimensions w and z */
  orientation: string[];
  /** uint16 i = I1/<I1> per grain over stress_max */
  stress: string;
  stress_max: number;
  cylinder?: { axis: number; centre: number[]; radius: number };
}

/** One packing: nodes are grains, then beads of walls, then points where a line ends at a wall or a periodic border. */
export interface NetworkFrame {
  rho: number;
  /** only there because it is the first where its system is jammed */
  own?: boolean;
  /** of a container: the stage that ended here */
  stage?: string;
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
  clusters?: Clusters;
}

export interface Networks {
  systems: NetworkFrame[][];
}

/** Regions of S1's diagrams. */
export type Bin = "rough" | "weak" | "medium" | "strong";

export interface DiagramFrame {
  rho: number;
  own?: boolean;
  stage?: string;
  realisation: number;
  /** per dimension: uint16 birth, death per pair over value_max; one byte per pair: 1 = never dies; points per bin */
  dimensions: { pairs: number; values: string; essential: string; bins: Record<Bin, number> }[];
  value_max: number;
}

export interface Diagrams {
  systems: DiagramFrame[][];
}

/** block "final": the last states of containers, mean and standard error over realisations; null for other systems */
export interface Final {
  systems: ({ realisations: number; quantities: Record<string, { mean: number; se: number | null }> } | null)[];
}

/** A shape as the block "shapes" has it: lengths in d, distances of neighbours in L (null where S3 gives none). */
export interface ShapeFacts extends ClusterShape {
  name: string;
  sphericity: number;
  aspect: number;
  volume: number;
  surface: number;
  area: number;
  inertia: number[];
  d1: number | null;
  d2: number | null;
  d3: number | null;
  j1: number | null;
}

/** block "shapes": per system, null for discs and spheres */
export interface Shapes {
  systems: (ShapeFacts[] | null)[];
}

interface Curve {
  x: number[];
  y: number[];
}

/** block "conzelmann": what S3 prints */
export interface Conzelmann {
  /** Mueth's law over f */
  mueth: Curve;
  exponents: { domain: string; sphericity: number; exponent: number; error: number | null }[];
  /** fits of the exponent over sphericity */
  exponent_2d: Curve;
  exponent_slab: Curve;
  /** sphericities that a value of the text stands for */
  plateau: [number, number];
  critical: { crosses: number; stars: number };
  peaks: { dimension: number; sphericity: number; peaks: (number | null)[] }[];
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
  final: Final | null;
  shapes: Shapes | null;
  conzelmann: Conzelmann | null;
  distribution: (measure: string) => Distribution | null;
  finalDistribution: (measure: string) => FinalDistribution | null;
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
    final: block("final"),
    shapes: block("shapes"),
    conzelmann: block("conzelmann"),
    distribution: (measure) => block(`many-${measure}`),
    finalDistribution: (measure) => block(`many-${measure}`),
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

/** A quantity of the final state of a container: of all realisations pooled, where that was taken; else their mean. */
export function finalValue(data: Data, system: number, quantity: string): { mean: number; se: number | null } | null {
  const quantities = data.final?.systems[system]?.quantities;
  return quantities?.[`${quantity}_pooled`] ?? quantities?.[quantity] ?? null;
}

/** The shape of a system's grains; null for discs, spheres and mixtures. */
export function shapeOf(data: Data, system: number): ShapeFacts | null {
  const shapes = data.shapes?.systems[system];
  return shapes?.length === 1 ? shapes[0] : null;
}

export function dimensionOf(study: Study, system: number): number {
  return Number(study.systems[system].options["domain.dimension"] ?? 2);
}
