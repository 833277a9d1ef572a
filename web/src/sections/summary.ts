// What was simulated, and where each system jams.
import type { Context, Section } from "../context";
import type { Score, Verdict } from "../data";
import { escape, h, table } from "../dom";
import { compact, plain, withError } from "../numbers";
import { optionSymbol, optionValue } from "../symbols";
import { systemColour } from "../theme";

const ALWAYS = ["grains.count", "grains.width", "contact.friction"];

function label(context: Context, system: number): string {
  return `<i class="swatch" style="background:${systemColour(system)}"></i>${context.labels[system]}`;
}

/** With the system's name where the label is made of options. */
function namedLabel(context: Context, system: number): string {
  const name = escape(context.data.study.systems[system].name);
  return label(context, system) + (name === context.labels[system] ? "" : ` <span class="what">${name}</span>`);
}

function systemsTable(context: Context): HTMLElement {
  const { study } = context.data;
  const keys = [...ALWAYS, ...study.swept.filter((key) => !ALWAYS.includes(key))].filter((key) =>
    study.systems.some((s) => key in s.options || key in s.swept),
  );
  const hasSpeed = study.systems.some((s) => "speed" in s.options);
  const head = ["system", ...keys.map(optionSymbol), ...(hasSpeed ? ["wall speed <small>d/τ<sub>c</sub></small>"] : []), "realisations"];
  const rows = study.systems.map((s, k) => [
    namedLabel(context, k),
    ...keys.map((key) => optionValue(s.swept[key] ?? s.options[key] ?? "–")),
    ...(hasSpeed ? [optionValue(s.options.speed ?? "–")] : []),
    s.planned !== null && s.planned !== s.realisations ? `${s.realisations} of ${s.planned}` : String(s.realisations),
  ]);
  return table("numbers", head, rows);
}

export const summary: Section = {
  id: "systems",
  title: "What was simulated",
  build(context) {
    return [systemsTable(context)];
  },
};

const VARIANTS: Record<string, string> = {
  rho_c: "<i>Z</i> of all grains, mean curve",
  rho_c_walls: "wall contacts counted",
  rho_c_multi: "grains with ≥ 2 contacts",
  rho_c_plain: "plain area",
  rho_inflection: "inflection of <i>Z</i>(<i>ρ</i>)",
  rho_c_single: "mean of single runs",
};

export const transitions: Section = {
  id: "transitions",
  title: "Where the systems jam",
  build(context) {
    const { transitions, score } = context.data;
    const out: HTMLElement[] = [];
    const rows = transitions?.rows ?? [];
    const quantities = [...new Set(rows.map((r) => r.quantity))];
    const published = new Map(score?.published.map((p) => [p.system, plain(p.value)]));
    if (rows.length) {
      const found = (system: number, quantity: string) =>
        rows.find((r) => r.system === system && r.quantity === quantity);
      const head = [
        "system",
        "runs",
        ...(published.size ? ["published <i>ρ</i><sub>c</sub>"] : []),
        ...quantities.map((q) => (q === "rho_c" ? "<i>ρ</i><sub>c</sub> (<i>Z</i> = 3)" : (VARIANTS[q] ?? escape(q)))),
      ];
      const body = context.data.study.systems.map((_, k) => [
        label(context, k),
        String(found(k, "rho_c")?.n ?? "–"),
        ...(published.size ? [published.get(k) ?? "–"] : []),
        ...quantities.map((q) => {
          const row = found(k, q);
          if (!row) return "–";
          return q === "rho_c" ? `<b>${withError(row.value, row.se)}</b>` : compact(row.value, row.se);
        }),
      ]);
      out.push(
        table("numbers", head, body),
        note(
          "<i>ρ</i><sub>c</sub>: last upward crossing of the ensemble mean of <i>Z</i> = 2<i>N</i><sub>pp</sub>/<i>N</i> at 3, " +
            "linear interpolation between frames, jackknife standard error over realisations. The other columns count " +
            "<i>Z</i> or the packing fraction in another way; digits in brackets are the standard error of the last ones.",
        ),
      );
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
