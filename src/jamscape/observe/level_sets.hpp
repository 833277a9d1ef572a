// The force network at many thresholds, as S2 looks at it: the part of it with F > F_th, F in mean forces.
//
//   B_k           Betti numbers of its clique complex: pieces, loops of four or more, voids (topology/betti.hpp)
//   <S>/N         mean size of the clusters that do not percolate, N all grains (rattlers among them)
//   N_per/N       grains of the clusters that percolate
//   S_p           edges/grains of a cluster, mean over clusters
//
// With measure.tetrahedra = "hollow" no tetrahedra are in the complex: B_2 then counts four mutually touching grains as
// a void, by B_2 = V - E + T - B_0 + B_1 (T triangles; B_0 and B_1 do not change). S2 does not say which it takes.
//
// A grain is in a cluster through an edge only, at F_th = 0 too, so that clusters of both kinds add up to B_0.
// network/level_sweep.hpp says when a cluster percolates. Source: S2 Sec. 4.2, 4.3, 5.1, 5.2; theory sec. 4.
#pragma once

#include "jamscape/observe/measure.hpp"

namespace jam {

/// B_2 of the network's vertices in edges, edges and triangles with values above each threshold, from its B_0 and B_1
/// there; all three of the same length.
std::vector<double> hollow_voids(const WeightedGraph& graph, const std::vector<double>& thresholds,
                                 const std::vector<double>& b0, const std::vector<double>& b1);

Measure level_sets_measure();

}  // namespace jam
