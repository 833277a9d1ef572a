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
import { contactForces } from "./sections/contact_forces";
import { finalStates } from "./sections/final_states";
import { particleStress } from "./sections/particle_stress";
import { radial } from "./sections/radial";
import { shapes } from "./sections/shapes";
import { coordination, order } from "./sections/structure";
import { summary, transitions } from "./sections/summary";
import { surfaces } from "./sections/surfaces";
import { topology } from "./sections/topology";
import { State } from "./state";

const SECTIONS: Section[] = [
  summary,
  shapes,
  transitions,
  networks,
  contactForces,
  radial,
  particleStress,
  finalStates,
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
  const context = new Context(data, new State(data.study.systems.length, data.shapes !== null));
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
      "persistence: two- and three-dimensional compressed granular systems</i>, arXiv:1901.08675.<br>S3: N. A. Conzelmann, A. Penn, " +
      "M. N. Partl, F. J. Clemens, L. D. Poulikakos, C. R. Müller, <i>The link between packing morphology and the distribution of " +
      "contact forces and stresses in packings of highly non-convex particles</i> (2020).",
    "p",
  );
  return h("footer", "", text, h("p", "", `Written by ${program} from the study's result files.`));
}

build();
