// What is shown of the network of forces above a threshold, with its captions.

export interface Quantity {
  column: string;
  title: string;
  perGrain: boolean;
  text: string;
  formula: string;
  source: string;
}

export const QUANTITIES: Quantity[] = [
  {
    column: "mean_cluster_pooled",
    title: "⟨<i>S</i>⟩/<i>N</i> <span class=\"what\">mean size of a cluster</span>",
    perGrain: false,
    text:
      "Mean number of grains in a cluster that does not percolate, per grain of the packing. A cluster is what forces " +
      "above the threshold hold together.",
    formula: "grains in such clusters / (<i>N</i> × their number), pooled over realisations",
    source: "S2 Sec. 4.2, Fig. 4.",
  },
  {
    column: "percolating_grains",
    title: "<i>N</i><sub>per</sub>/<i>N</i> <span class=\"what\">grains in the percolating cluster</span>",
    perGrain: false,
    text:
      "Part of the grains that belong to a cluster which joins two opposite walls (or winds around a periodic box): mean " +
      "over the realisations that have one. Hatched: fewer than half of them do.",
    formula: "",
    source: "S2 Sec. 4.3, Fig. 5.",
  },
  {
    column: "b0",
    title: "<i>B</i><sub>0</sub>/<i>N</i> <span class=\"what\">clusters per grain</span>",
    perGrain: true,
    text: "Number of clusters, the percolating one included, per grain.",
    formula: "<i>B<sub>k</sub></i>: Betti numbers of the clique complex of all contacts with <i>F</i> > <i>F</i><sub>th</sub>",
    source: "S2 Sec. 5.1, Figs. 2 and 6.",
  },
  {
    column: "b1",
    title: "<i>B</i><sub>1</sub>/<i>N</i> <span class=\"what\">loops per grain</span>",
    perGrain: true,
    text: "Number of loops of four contacts or more per grain; loops of three touching grains are filled.",
    formula: "",
    source: "S2 Sec. 5.1, Fig. 7.",
  },
  {
    column: "b2",
    title: "<i>B</i><sub>2</sub>/<i>N</i> <span class=\"what\">voids per grain</span>",
    perGrain: true,
    text: "Number of voids enclosed by the network per grain, in three dimensions.",
    formula: "",
    source: "S2 Sec. 5.1.",
  },
  {
    column: "shape",
    title: "<i>S<sub>p</sub></i> <span class=\"what\">contacts per grain in a cluster</span>",
    perGrain: false,
    text:
      "Shape of the clusters: an open path has less than 1, a ring 1, an entangled cluster more. Zero where at least half " +
      "of the realisations have no cluster.",
    formula: "<i>S<sub>p</sub></i> = ⟨contacts/grains⟩ over the clusters of a realisation, percolating ones included",
    source: "S2 Sec. 5.2, Figs. 8 and 9.",
  },
];
