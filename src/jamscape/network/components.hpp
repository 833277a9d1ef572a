// Connected pieces of a graph at a threshold.
//
// A vertex has the largest weight of its edges as its value, 0 without edges. The level set keeps the vertices and
// edges whose value reaches the threshold. Level::at_least is S1's f >= theta (theory sec. 4), Level::above S2's F >
// F_th.
#pragma once

#include <cstdint>
#include <vector>

#include "jamscape/network/graph.hpp"
#include "jamscape/network/level.hpp"

namespace jam {

struct Components {
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

  std::vector<std::uint32_t> of;     ///< one entry a vertex: its component, kNone below the threshold
  std::vector<std::uint32_t> size;   ///< vertices, one entry a component; components in order of their first vertex
  std::vector<std::uint32_t> edges;  ///< edges, one entry a component

  std::uint32_t count() const { return static_cast<std::uint32_t>(size.size()); }
};

Components components(const WeightedGraph& graph, double threshold, Level level = Level::at_least);

}  // namespace jam
