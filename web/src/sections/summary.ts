// What was simulated, and where each system jams.
import type { Context, Section } from "../context";
import { jammingSymbol, type Score, type System, type Verdict } from "../data";
import { escape, h, table } from "../dom";
import { compact, plain, withError, withUnit } from "../numbers";
import { optionSymbol, optionValue } from "../symbols";
import { systemColour } from "../theme";

const ALWAYS = ["grains.count", "grains.width", "contact.friction"];

/** Options that name the physics of a system; of many that differ only these head the table. */
const TELLING = [
  ...ALWAYS,
  "grains.size_ratio",
  "grains.sizes",
  "domain.dimension",
  "domain.walls",
  "contact.law",
  "contact.damping",
  "contact.restitution",
];
const MANY = 5;

function label(context: Context, system: number): string {
  return `<i class="swatch" style="background:${systemColour(system)}"></i>${context.labels[system]}`;
}

/** With the system's name where the label is made of options. */
function namedLabel(context: Context, system: number): string {
  const name = escape(context.data.study.systems[system].name);
  return label(context, system) + (name === context.labels[system] ? "" : ` <span class="what">${name}</span>`);
}

/** A row per system; `more` columns at the end. */
function optionsTable(context: Context, keys: string[], more: { head: string; cell: (system: System) => string }[]): HTMLElement {
  const { systems } = context.data.study;
  const rows = systems.map((s, k) => [
    namedLabel(context, k),
    ...keys.map((key) => optionValue(s.swept[key] ?? s.options[key] ?? "–")),
    ...more.map(({ cell }) => cell(s)),
  ]);
  return table("numbers", ["system", ...keys.map(optionSymbol), ...more.map(({ head }) => head)], rows);
}

function systemsTable(context: Context): HTMLElement[] {
  const { study } = context.data;
  const known = (key: string) => study.systems.some((s) => key in s.options || key in s.swept);
  const many = study.swept.length > MANY;
  const differing = study.swept.filter((key) => !many || TELLING.includes(key));
  const keys = [...ALWAYS, ...differing.filter((key) => !ALWAYS.includes(key))].filter(known);
  const more = [];
  if (study.systems.some((s) => "speed" in s.options))
    more.push({ head: "wall speed <small>d/τ<sub>c</sub></small>", cell: (s: System) => optionValue(s.options.speed ?? "–") });
  more.push({
    head: "realisations",
    cell: (s: System) => (s.planned !== null && s.planned !== s.realisations ? `${s.realisations} of ${s.planned}` : String(s.realisations)),
  });
  if (study.systems.some((s) => s.relaxations))
    more.push(
      {
        head: "relaxed <small>by fluctuation, by energy</small>",
        cell: ({ relaxations: r }: System) => (r ? `${r.fluctuation}, ${r.energy}` : "–"),
      },
      { head: "not relaxed", cell: notRelaxed },
    );
  if (study.systems.some((s) => s.ledger))
    more.push({
      head: "energy ledger off",
      cell: ({ ledger: l }: System) =>
        l ? `<b class="hollow">${l.frames} frames, ×</b> from <i>ρ</i> = ${plain(l.from, 4)}, by up to ${plain(100 * l.worst, 3)} %` : "–",
    });
  const rest = study.swept.filter((key) => !keys.includes(key));
  if (!rest.length) return [optionsTable(context, keys, more)];
  const all = h("details", "", h("summary", "", `${rest.length} more options that differ`), optionsTable(context, rest, []));
  return [optionsTable(context, keys, more), all];
}

/** How many states of how many, over all realisations. */
function notRelaxed({ relaxations: ended }: System): string {
  if (!ended) return "–";
  const all = ended.fluctuation + ended.energy + ended.budget;
  return ended.budget ? `<b class="hollow">${ended.budget} of ${all}</b>` : `0 of ${all}`;
}

/** What the units of the results are in SI, or null. */
function unitsOf(context: Context): string | null {
  const { systems } = context.data.study;
  const known = systems.find((s) => s.scales)?.scales;
  if (!known) return null;
  const times = new Map<string, string[]>();
  systems.forEach((s, k) => {
    if (!s.scales) return;
    const time = withUnit(s.scales.time, "s");
    times.set(time, [...(times.get(time) ?? []), context.labels[k]]);
  });
  const few = systems.length <= 6;
  const listed = [...times].map(([time, names]) => (times.size > 1 && few ? `${time} (${names.join(", ")})` : time));
  if (context.data.shapes)
    return (
      `Results are in units of the diameter of an arm, <i>d</i> = ${withUnit(known.length, "m")}, the mass ` +
      `<i>m</i> = ${withUnit(1000 * known.mass, "g")} and the time ${listed.join(", ")}.`
    );
  return (
    `Results are in units of the mean diameter <i>d</i> = ${withUnit(known.length, "m")}, the mean mass ` +
    `<i>m</i> = ${withUnit(1000 * known.mass, "g")} and the collision time <i>τ</i><sub>c</sub> = ` +
    `${listed.join(few ? ", " : " or ")}.`
  );
}

export const summary: Section = {
  id: "systems",
  title: "What was simulated",
  build(context) {
    const relaxes = context.data.study.systems.some((s) => s.relaxations);
    const scales = unitsOf(context);
    return [
      ...systemsTable(context),
      ...(scales ? [note(scales)] : []),
      ...(context.data.study.systems.some((s) => s.ledger)
        ? [
            note(
              `The integrator made or lost energy: in the frames counted here, by more than ${plain(100 * (context.data.study.ledger?.mark ?? 0.01), 3)} % of ` +
                "what was turned over (the kinetic energy of the start, the work of walls and gravity, what dashpots and friction took). " +
                (context.data.study.ledger?.open ? "Means take them in; crosses" : "They enter no mean; crosses") +
                " (×) at the foot of the curves show where they lie.",
            ),
          ]
        : []),
      ...(relaxes
        ? [
            note(
              "Walls stop before a state is measured, until the kinetic energy hardly fluctuates or is negligible beside the " +
                "elastic energy. A state that came to neither within its budget is not relaxed: the table counts " +
                `these${context.data.frames ? ", and hollow points (○) mark them in all curves" : ""}.`,
            ),
          ]
        : []),
    ];
  },
};

const VARIANTS: Record<string, string> = {
  rho_c: "<i>ρ</i><sub>c</sub> (<i>Z</i> = 3)",
  rho_j: "<i>ρ</i><sub>J</sub> (inflection of <i>Z</i>)",
  z_at_rho_j: "<i>Z</i> at <i>ρ</i><sub>J</sub>",
  z_above: "<i>Z</i> just above",
  rho_j_backbone: "<i>ρ</i><sub>J</sub> without rattlers",
  z_backbone_at_rho_j: "<i>Z</i> there, without rattlers",
  z_backbone_above: "<i>Z</i> just above, without rattlers",
  rho_p: "<i>ρ</i><sub>p</sub>, first percolation",
  rho_c_walls: "wall contacts counted",
  rho_c_multi: "grains with ≥ 2 contacts",
  rho_c_plain: "plain area",
  rho_inflection: "inflection of <i>Z</i>(<i>ρ</i>)",
  rho_c_single: "mean of single runs",
};

const CROSSING =
  "<i>ρ</i><sub>c</sub>: last upward crossing of the ensemble mean of <i>Z</i> = 2<i>N</i><sub>pp</sub>/<i>N</i> at 3, " +
  "linear interpolation between frames, jackknife standard error over realisations. The other columns count " +
  "<i>Z</i> or the packing fraction in another way; digits in brackets are the standard error of the last ones.";

const INFLECTION =
  "<i>ρ</i><sub>J</sub>: inflection of the ensemble mean of <i>Z</i> = 2<i>N</i><sub>pp</sub>/<i>N</i> over the relaxed states, " +
  "bootstrap standard error over realisations. <i>Z</i> at that point is about half way up its jump; the plateau begins at " +
  "the first state above. Rattlers touch fewer than two grains or walls and are removed once. Digits in brackets are the " +
  "standard error of the last ones.";

export const transitions: Section = {
  id: "transitions",
  title: ({ data }) => (data.transitions ? "Where the systems jam" : "Published values beside ours"),
  build(context) {
    const { transitions, score } = context.data;
    const out: HTMLElement[] = [];
    const rows = transitions?.rows ?? [];
    const main = rows.some((r) => r.quantity === "rho_j") ? "rho_j" : "rho_c";
    // Where Z(rho) has an inflection of its own, readings of Z = 3 say nothing. What is not named is no transition.
    const quantities = [...new Set(rows.map((r) => r.quantity))].filter(
      (q) => q in VARIANTS && (main === "rho_c" || !(q.startsWith("rho_c") || q === "rho_inflection")),
    );
    quantities.sort((a, b) => Number(b === main) - Number(a === main));
    const published = new Map(score?.published.map((p) => [p.system, plain(p.value)]));
    if (rows.length) {
      const found = (system: number, quantity: string) =>
        rows.find((r) => r.system === system && r.quantity === quantity);
      const head = [
        "system",
        "runs",
        ...(published.size ? [`published ${jammingSymbol(context.data)}`] : []),
        ...quantities.map((q) => VARIANTS[q]),
      ];
      const body = context.data.study.systems.map((_, k) => [
        label(context, k),
        String(found(k, main)?.n ?? "–"),
        ...(published.size ? [published.get(k) ?? "–"] : []),
        ...quantities.map((q) => {
          const row = found(k, q);
          if (!row) return "–";
          return q === main ? `<b>${withError(row.value, row.se)}</b>` : compact(row.value, row.se);
        }),
      ]);
      out.push(table("numbers", head, body), note(main === "rho_c" ? CROSSING : INFLECTION));
    }
    if (score?.rows.length) out.push(scoreTable(score));
    return out.length ? out : null;
  },
};

const VERDICTS: Verdict[] = ["pass", "fail", "known deviation", "insufficient"];

function badge(verdict: Verdict, text: string = verdict): string {
  return `<span class="verdict ${verdict.split(" ")[0]}">${text}</span>`;
}

/** Folded away behind its sum, because it is long. */
function scoreTable(score: Score): HTMLElement {
  const rows = score.rows.map((row) => [
    badge(row.verdict),
    escape(row.target),
    escape(row.systems.replace(">", " > ")),
    escape(row.published).replace("+-", "±"),
    row.ours === null ? "–" : withError(row.ours, row.error),
    `${row.n} of ${row.needed}`,
    escape(row.source),
    escape(row.note),
  ]);
  const head = ["verdict", "target", "systems", "published", "ours", "runs", "source", "note"];
  const counts = VERDICTS.map((v) => [v, score.rows.filter((r) => r.verdict === v).length] as const)
    .filter(([, count]) => count > 0)
    .map(([verdict, count]) => badge(verdict, `${count} ${verdict === "insufficient" ? "with too few runs" : verdict}`));
  const summary = h("summary");
  summary.innerHTML = `<b>Published values and orders, row by row</b> ${counts.join(" ")}`;
  return h("details", "score", summary, table("score", head, rows));
}

function note(html: string): HTMLElement {
  const element = document.createElement("p");
  element.className = "note";
  element.innerHTML = html;
  return element;
}
