// The force network at many thresholds, as S2 looks at it: the part of it with F > F_th, F in mean forces.
//
//   B_k           Betti numbers of its clique complex: pieces, loops of four or more, voids (topology/betti.hpp)
//   <S>/N         mean size of the clusters that do not percolate, N all grains (rattlers among them)
//   N_per/N       grains of the clusters that percolate
//   S_p           edges/grains of a cluster, mean over clusters
//
// A grain is in a cluster through an edge only, at F_th = 0 too, so that clusters of both kinds add up to B_0.
// network/level_sweep.hpp says when a cluster percolates. Source: S2 Sec. 4.2, 4.3, 5.1, 5.2; theory sec. 4.
#pragma once

#include "jamscape/observe/measure.hpp"

namespace jam {

Measure level_sets_measure();

}  // namespace jam
