#include "jamscape/network/triangles.hpp"

#include <algorithm>
#include <limits>

namespace jam {
namespace {

struct Neighbour {
  std::uint32_t vertex;
  double weight;
};

}  // namespace

std::vector<double> triangle_weights(const WeightedGraph& graph) {
  // Every edge is kept at its end of smaller number, so that a triangle a < b < c is found once, from a.
  std::vector<std::uint32_t> begin(std::size_t{graph.vertices} + 1, 0);
  for (std::size_t e = 0; e < graph.edges(); ++e) ++begin[std::min(graph.from[e], graph.to[e]) + 1];
  for (std::size_t v = 0; v < graph.vertices; ++v) begin[v + 1] += begin[v];
  std::vector<Neighbour> up(graph.edges());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (std::size_t e = 0; e < graph.edges(); ++e) {
    const auto [low, high] = std::minmax({graph.from[e], graph.to[e]});
    up[next[low]++] = {high, graph.weight[e]};
  }
  constexpr double none = -std::numeric_limits<double>::infinity();
  std::vector<double> to_first(graph.vertices, none);  // weight of the edge to a
  std::vector<double> triangles;
  for (std::size_t a = 0; a < graph.vertices; ++a) {
    for (std::uint32_t k = begin[a]; k < begin[a + 1]; ++k) to_first[up[k].vertex] = up[k].weight;
    for (std::uint32_t k = begin[a]; k < begin[a + 1]; ++k) {
      const Neighbour b = up[k];
      for (std::uint32_t m = begin[b.vertex]; m < begin[b.vertex + 1]; ++m)
        if (to_first[up[m].vertex] != none)
          triangles.push_back(std::min({b.weight, up[m].weight, to_first[up[m].vertex]}));
    }
    for (std::uint32_t k = begin[a]; k < begin[a + 1]; ++k) to_first[up[k].vertex] = none;
  }
  return triangles;
}

}  // namespace jam
