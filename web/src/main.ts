// The report's page: a header, the legend, and the sections in their order. A section without data is left out.
import "./pixel_ratio";
import { Context, type Section } from "./context";
import { load } from "./data";
import { h, markup } from "./dom";
import { legend } from "./legend";
import { header } from "./header";
import { diagrams } from "./sections/diagrams";
import { explorer } from "./sections/explorer";
import { forces } from "./sections/forces";
import { generators } from "./sections/generators";
import { mechanics } from "./sections/mechanics";
import { networks } from "./sections/networks";
import { coordination, order } from "./sections/structure";
import { summary, transitions } from "./sections/summary";
import { surfaces } from "./sections/surfaces";
import { topology } from "./sections/topology";
import { State } from "./state";

const SECTIONS: Section[] = [
  summary,
  transitions,
  networks,
  diagrams,
  generators,
  coordination,
  surfaces,
  topology,
  forces,
  order,
  mechanics,
  explorer,
];

function build(): void {
  const data = load();
  const context = new Context(data, new State(data.study.systems.length));
  const page = document.getElementById("report")!;
  const links: HTMLElement[] = [];
  const body: HTMLElement[] = [];
  for (const section of SECTIONS) {
    const content = section.build(context);
    if (!content) continue;
    const title = typeof section.title === "string" ? section.title : section.title(context);
    const element = h("section", "", h("h2", "", title), ...content);
    element.id = section.id;
    const link = h("a", "", title);
    link.href = `#${section.id}`;
    links.push(link);
    body.push(element);
  }
  page.replaceChildren(header(context, links), legend(context), ...body, footer(data.study.program));
  document.documentElement.dataset.ready = "true";
}

function footer(program: string): HTMLElement {
  const text = markup(
    "Bands are ± one standard error over realisations. Colours follow Okabe and Ito and stay apart for all kinds of colour " +
      "vision. The page holds all it shows and loads nothing.<br>S1: M. Kramár, A. Goulet, L. Kondic, K. Mischaikow, " +
      "<i>Persistence of force networks in compressed granular media</i>, Phys. Rev. E 87, 042207 (2013).<br>S2: L. Kovalcinova, A. Taranto, L. Kondic, <i>Interaction networks in " +
      "persistence: two- and three-dimensional compressed granular systems</i>, arXiv:1901.08675.",
    "p",
  );
  return h("footer", "", text, h("p", "", `Written by ${program} from the study's result files.`));
}

build();
