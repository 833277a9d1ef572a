// The force network of a packing: the bridge from grains to graphs.
//
//   vertices  grains;   edges  pairs of grains that touch (bonds.hpp), one however many contacts two clusters have;
//             wall contacts are no edges
//   weight    f = |F|/<F>, at most `clamp`;   F = sum of F_n n over the contacts of the pair (S1), or of F_n n - f_t,
//             the whole contact force (S2);   <F> = mean of |F| over the edges kept, before the clamp
//
// Rattlers are grains with fewer than two contacts (walls count). Where they stay (S1), the vertices are all grains. With
// `remove_rattlers` (S2) they go with their edges first, once and not recursively, and are no vertices: a grain that
// loses its edges by that stays, as one without edges.
// Source: S1 Sec. II.C and App. B, S2 Sec. 4, theory sec. 4.
#pragma once

#include <cstdint>
#include <vector>

#include "jamscape/network/graph.hpp"
#include "jamscape/observe/bonds.hpp"
#include "jamscape/observe/options.hpp"
#include "jamscape/packing/packing.hpp"

namespace jam {

struct ForceNetwork {
  WeightedGraph graph;                 ///< weights in mean forces
  std::vector<std::uint32_t> grain;    ///< of each vertex: its index in Packing::grains; empty where they are the same
  double mean_force = 0;               ///< mean over the edges kept, before normalisation and clamp
  std::size_t grains = 0;              ///< all grains, or without the rattlers where they are removed
  std::vector<std::uint32_t> contact;  ///< of each edge: the index of its (first) contact in Packing::contacts
  std::vector<double> force;           ///< of each edge: |F| before normalisation and clamp
};

ForceNetwork force_network(const Packing& packing, const Bonds& bonds, const MeasureOptions& options);

}  // namespace jam
