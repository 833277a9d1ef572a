// A quantity of the final states over the sphericity of the grains: a line per kind of container, and published values.
import type { ChartOptions, Line } from "./chart/options";
import type { Context } from "./context";
import { finalValue, shapeOf } from "./data";
import { h, markup } from "./dom";
import { dashLabels, kindsOf, type Kind } from "./kinds";
import { INK, paletteColour } from "./theme";

interface Key {
  /** markup */
  label: string;
  dashed?: boolean;
  marker?: Line["marker"];
  /** a filled mark: our values */
  solid?: boolean;
}

export interface Reference extends Key {
  line: Line;
}

const LINES = ["", "dashed", "dotted", "dashed"];

/** What full, dashed and dotted lines mean; nothing where all are full. */
export function dashKey(context: Context): HTMLElement[] {
  const labels = dashLabels(context.data);
  if (labels.length < 2) return [];
  const entries = labels.map((label, k) => {
    const sample = h("i", `sample ${LINES[k % LINES.length]}`);
    sample.style.color = INK;
    return h("span", "", sample, markup(label));
  });
  return [h("div", "line-key", ...entries)];
}

/** What lines and marks mean, below a chart. */
export function referenceKey(entries: (Key & { colour: string })[]): HTMLElement {
  const key = h("div", "line-key");
  for (const { label, colour, dashed, marker, solid } of entries) {
    const sample = h("i", marker ? `sample ${marker}${solid ? " solid" : ""}` : dashed ? "sample dashed" : "sample");
    sample.style.color = colour;
    key.append(h("span", "", sample, markup(label)));
  }
  return key;
}

const MARKERS: Line["marker"][] = ["disc", "square", "triangle", "diamond"];

function lineOf(context: Context, kind: Kind, index: number, quantity: string): Line | null {
  const shown = context.state.shown.get();
  const points = kind.systems
    .filter((k) => shown[k])
    .flatMap((k) => {
      const value = finalValue(context.data, k, quantity);
      return value ? [{ x: shapeOf(context.data, k)!.sphericity, ...value }] : [];
    })
    .sort((a, b) => a.x - b.x);
  const known = kind.systems.some((k) => finalValue(context.data, k, quantity));
  if (!known) return null;
  return {
    label: kind.label,
    colour: paletteColour(index),
    width: 1.4,
    marker: MARKERS[index % MARKERS.length],
    joined: true,
    bars: true,
    x: points.map((p) => p.x),
    y: points.map((p) => p.mean),
    se: points.map((p) => p.se),
  };
}

/** Null where no system has the quantity; `dimension` keeps to the systems that have this one. */
export function overSphericity(
  context: Context,
  quantity: string,
  title: string,
  references: Reference[] = [],
  more: Partial<ChartOptions> = {},
  dimension?: number,
): HTMLElement | null {
  const kinds = kindsOf(context.data);
  const wanted = (kind: Kind) => dimension === undefined || kind.dimension === dimension;
  const lines = () =>
    kinds.map((kind, k) => (wanted(kind) ? lineOf(context, kind, k, quantity) : null)).filter((line) => line !== null);
  const first = lines();
  if (!first.length) return null;
  const all = () => [...references.map((r) => r.line), ...lines()];
  const made = context.chart({
    title,
    xLabel: "sphericity <i>ψ</i>",
    xName: "<i>ψ</i>",
    lines: all(),
    xRange: [0.4, 1.02],
    height: 300,
    ...more,
  });
  context.state.shown.watch(() => made.replace(all()));
  const own = first.map((line) => ({ label: line.label, colour: line.colour, marker: line.marker, solid: line.marker !== "triangle" }));
  const printed = references.map((r) => ({ ...r, colour: r.line.colour }));
  return h("div", "", made.element, referenceKey([...own, ...printed]));
}
