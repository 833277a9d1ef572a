// Colours. Systems: Okabe and Ito's palette (distinguishable with any colour vision), darkened where it is too pale for
// lines on white. Forces and densities: one ramp whose lightness falls steadily.

const SYSTEMS = ["#0072b2", "#d55e00", "#009e73", "#b4508e", "#1b1b1b", "#c99700", "#56b4e9", "#8c564b"];
const DASHES: (number[] | undefined)[] = [undefined, [7, 4], [2, 3], [9, 3, 2, 3]];

/** Colours that mean something in this study, by system; empty where the palette serves. */
let own: { colour: string; dash: number }[] = [];

/** `dash` tells lines of one colour apart: 0 for a full line, and so on. */
export function assignColours(colours: { colour: string; dash: number }[]): void {
  own = colours;
}

export function paletteColour(index: number): string {
  return SYSTEMS[index % SYSTEMS.length];
}

export function systemColour(index: number): string {
  return own[index]?.colour ?? paletteColour(index);
}

/** Systems beyond the palette's length repeat its colours with dashes. */
export function systemDash(index: number): number[] | undefined {
  if (own.length) return DASHES[own[index].dash % DASHES.length];
  return DASHES[Math.floor(index / SYSTEMS.length) % DASHES.length];
}

export function faded(colour: string, alpha: number): string {
  const value = parseInt(colour.slice(1), 16);
  return `rgba(${value >> 16},${(value >> 8) & 255},${value & 255},${alpha})`;
}

const RAMP = ["#fbe3b3", "#f9b96b", "#ef7d4f", "#cf4461", "#8e2b74", "#45175f", "#160b39"];
const RHO_RAMP = ["#b9d3e6", "#7fb3d3", "#4a90c0", "#2b6ca3", "#1d4a7d", "#0f2c55"];

// Viridis (Smith and van der Walt): equal steps look equal, with any colour vision and in grey.
const VIRIDIS = ["#440154", "#482475", "#414487", "#355f8d", "#2a788e", "#21918c", "#22a884", "#44bf70", "#7ad151", "#bddf26", "#fde725"];

/** Channels of "#rrggbb" from 0 to 255. */
export function channels(colour: string): [number, number, number] {
  const value = parseInt(colour.slice(1), 16);
  return [value >> 16, (value >> 8) & 255, value & 255];
}

/** The ramp of heat(), evenly spaced. */
export const HEAT_STOPS = RAMP.map(channels);

function mix(stops: string[], t: number): string {
  const position = Math.min(Math.max(t, 0), 1) * (stops.length - 1);
  const k = Math.min(Math.floor(position), stops.length - 2);
  const part = position - k;
  const a = parseInt(stops[k].slice(1), 16);
  const b = parseInt(stops[k + 1].slice(1), 16);
  const channel = (shift: number) => {
    const from = (a >> shift) & 255;
    return Math.round(from + part * (((b >> shift) & 255) - from));
  };
  return `rgb(${channel(16)},${channel(8)},${channel(0)})`;
}

/** t in [0, 1]: weak to strong. */
export const heat = (t: number): string => mix(RAMP, t);
/** t in [0, 1]: small to large values of a surface. */
export const surface = (t: number): string => mix(VIRIDIS, t);
/** t in [0, 1]: loose to dense. */
export const depth = (t: number): string => mix(RHO_RAMP, t);

/** A colour (either spelling) made darker or, with a factor above 1, lighter. */
export function shaded(colour: string, factor: number): string {
  const value = channels(colour.startsWith("#") ? colour : hex(colour));
  return `rgb(${value.map((c) => Math.min(255, Math.round(c * factor))).join(",")})`;
}

/** Part of the way to white. */
export function paler(colour: string, part: number): string {
  return hex(`rgb(${channels(colour).map((c) => Math.round(c + part * (255 - c))).join(",")})`);
}

/** "#rrggbb" of "rgb(r,g,b)". */
export function hex(rgb: string): string {
  const parts = rgb.match(/\d+/g)!.map(Number);
  return `#${parts.map((p) => p.toString(16).padStart(2, "0")).join("")}`;
}

/** Ranks in [0, 1], round to long arms: dark to light, but no paler than lines on white can be. */
export const shapeColour = (t: number): string => hex(mix(VIRIDIS.slice(0, 9), t));

export const INK = "#1f2733";
export const MUTED = "#667085";
export const GRID = "#eceff3";
export const FONT = 'system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif';
