// A weighted graph: vertices 0..vertices-1, undirected edges with a weight each. It knows no grains.
#pragma once

#include <cstdint>
#include <vector>

namespace jam {

struct WeightedGraph {
  std::uint32_t vertices = 0;
  std::vector<std::uint32_t> from, to;  ///< one entry per edge; from != to; no pair of vertices twice
  std::vector<double> weight;           ///< one entry per edge, >= 0

  std::size_t edges() const { return weight.size(); }
};

}  // namespace jam
