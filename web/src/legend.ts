// The bar that stays in view: one chip per system, which shows or hides it in all figures, and ready-made choices that
// vary one option while all others stay the same.
import type { Context } from "./context";
import { jammingSymbol, type Study, type System } from "./data";
import { h, markup } from "./dom";
import { kindsOf } from "./kinds";
import { optionSymbol, optionValue } from "./symbols";
import type { Abscissa } from "./state";
import { systemColour } from "./theme";

interface Group {
  label: string;
  members: boolean[];
}

/** With more options than these nobody reads what is held fixed. */
const MOST = 4;

/** Systems of the same dimension and force law, where there are several of them. */
function kinds(study: Study): Group[] {
  const keys = ["domain.dimension", "contact.law"].filter((key) => study.swept.includes(key));
  const kind = (system: System) =>
    keys.map((key) => (key === "domain.dimension" ? `${system.swept[key]}D` : optionValue(system.swept[key]))).join(" ");
  const names = [...new Set(study.systems.map(kind))];
  if (names.length < 2 || names.length === study.systems.length) return [];
  return names.map((name) => ({ label: name, members: study.systems.map((system) => kind(system) === name) }));
}

/** For each swept option, the largest set of systems (three at least, or all) that differ in nothing else. */
function groups(study: Study): Group[] {
  if (study.swept.length > MOST) return kinds(study);
  if (study.swept.length < 2) return [];
  const out: Group[] = [];
  for (const varied of study.swept) {
    const others = study.swept.filter((key) => key !== varied);
    const byRest = new Map<string, number[]>();
    study.systems.forEach((system, k) => {
      const rest = JSON.stringify(others.map((key) => system.swept[key]));
      byRest.set(rest, [...(byRest.get(rest) ?? []), k]);
    });
    for (const members of byRest.values()) {
      if (members.length < 3 || members.length === study.systems.length) continue;
      const fixed = others
        .map((key) => `${optionSymbol(key)} = ${optionValue(study.systems[members[0]].swept[key])}`)
        .join(", ");
      out.push({
        label: `vary ${optionSymbol(varied)} at ${fixed}`,
        members: study.systems.map((_, k) => members.includes(k)),
      });
    }
  }
  return out;
}

/** Containers of clusters, where there are several kinds. */
function kindGroups(context: Context): Group[] | null {
  const kinds = kindsOf(context.data);
  if (kinds.length < 2) return null;
  return kinds.map(({ label, systems }) => ({ label, members: context.labels.map((_, k) => systems.includes(k)) }));
}

/** A bar of more chips than these would cover too much of the screen to stay in view. */
const MANY = 12;

export function legend(context: Context): HTMLElement {
  const { shown } = context.state;
  const bar = h("div", context.labels.length > MANY ? "legend many" : "legend");
  const chips = context.labels.map((label, system) => {
    const chip = h("button", "chip", h("i", "swatch"), markup(label));
    (chip.firstChild as HTMLElement).style.background = systemColour(system);
    chip.title = "show or hide this system in all figures";
    chip.addEventListener("click", () => {
      const next = shown.get().map((on, k) => (k === system ? !on : on));
      shown.set(next.some(Boolean) ? next : next.map(() => true));
    });
    return chip;
  });
  shown.watch((on) => chips.forEach((chip, k) => chip.setAttribute("aria-pressed", String(on[k]))));
  bar.append(...chips);

  const choices = kindGroups(context) ?? groups(context.data.study);
  if (choices.length) {
    const all = { label: "all systems", members: context.labels.map(() => true) };
    const buttons = [all, ...choices].map((group) => {
      const button = h("button", "choice", markup(group.label));
      button.addEventListener("click", () => shown.set(group.members));
      shown.watch((on) => button.setAttribute("aria-pressed", String(on.every((v, k) => v === group.members[k]))));
      return button;
    });
    bar.append(h("span", "choices", ...buttons));
  }
  if (context.farApart) bar.append(abscissaChoice(context));
  return bar;
}

/** Curves of systems that jam far apart can be laid over each other. */
function abscissaChoice(context: Context): HTMLElement {
  const { abscissa } = context.state;
  const ways: [Abscissa, string][] = [
    ["rho", "over <i>ρ</i>"],
    ["distance", `over <i>ρ</i> − ${jammingSymbol(context.data)}`],
  ];
  const buttons = ways.map(([way, name]) => {
    const button = h("button", "choice", markup(name));
    button.addEventListener("click", () => abscissa.set(way));
    abscissa.watch((now) => button.setAttribute("aria-pressed", String(now === way)));
    return button;
  });
  return h("span", "choices", ...buttons);
}
