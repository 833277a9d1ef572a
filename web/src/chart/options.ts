// What a chart shows: its lines, marks and axes.
export interface Line {
  /** markup, for the tooltip */
  label: string;
  colour: string;
  dash?: number[];
  width?: number;
  /** opacity of the error band */
  band?: number;
  /** false: no dots even where the points are few */
  points?: boolean;
  /** points of this form, and no line between them unless `joined` */
  marker?: "disc" | "square" | "triangle" | "diamond";
  joined?: boolean;
  /** errors as bars at the points, in place of a band */
  bars?: boolean;
  /** drawn so much higher than it is */
  shift?: number;
  /** marks at the foot of a shifted line */
  notes?: { x: number; text: string }[];
  /** index of the system this line belongs to, when the legend may hide it */
  system?: number;
  x: number[];
  y: (number | null)[];
  se?: (number | null)[];
  /** per point, how many realisations were not relaxed; such points are hollow */
  unrelaxed?: number[];
  /** per point, of how many realisations the energy ledger is off; a cross at the foot of the chart */
  marked?: number[];
}

export interface Mark {
  x: number;
  colour: string;
  system?: number;
  /** "line" over the whole height, or a "tick" on the axis */
  kind: "line" | "tick";
  label?: string;
}

export interface ChartOptions {
  /** markup */
  title: string;
  xLabel: string;
  /** what x is called in the tooltip */
  xName: string;
  lines: Line[];
  marks?: Mark[];
  height?: number;
  log?: boolean;
  /** the ordinate starts at zero */
  zero?: boolean;
  xRange?: [number, number];
  yRange?: [number, number];
  /** in place of the numbers of the ordinate */
  ticks?: { at: number; text: string }[];
  /** a horizontal line worth seeing */
  level?: number;
  sync?: string;
  shown?: (system: number) => boolean;
}
