// How much memory the cliques of a graph will take, before they are found. Contact networks have a few an edge; a
// complete graph of n vertices has n^(k+1)/(k+1)! of dimension k.
#pragma once

#include "jamscape/network/graph.hpp"
#include "jamscape/topology/persistence.hpp"

namespace jam {

struct CliqueEstimate {
  double cliques = 0;  ///< of dimension 2 and above
  double bytes = 0;
  bool large = false;  ///< more than a gigabyte and more than contact networks have: to be asked for twice
};

/// An upper bound from the degrees where that is small; else from common neighbours of some thousand edges, and how
/// many of them are linked among each other: exact for complete graphs, about right for others. The same on every run.
CliqueEstimate estimate_cliques(const WeightedGraph& graph, const PersistenceOptions& options);

}  // namespace jam
