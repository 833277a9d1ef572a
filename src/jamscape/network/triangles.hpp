// The triangles of a graph: three vertices linked to each other.
#pragma once

#include <vector>

#include "jamscape/network/graph.hpp"

namespace jam {

/// Of each triangle the smallest weight of its edges: the threshold down to which all three are there. In no useful
/// order. Cost: linear in the number of edges where no vertex has many.
std::vector<double> triangle_weights(const WeightedGraph& graph);

}  // namespace jam
