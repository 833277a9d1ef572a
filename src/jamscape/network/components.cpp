#include "jamscape/network/components.hpp"

#include "jamscape/network/union_find.hpp"

namespace jam {

Components components(const WeightedGraph& graph, double threshold, Level level) {
  const auto reaches = [&](double w) { return keeps(level, w, threshold); };
  UnionFind sets(graph.vertices);
  std::vector<char> present(graph.vertices, reaches(0));
  for (std::size_t e = 0; e < graph.edges(); ++e) {
    if (!reaches(graph.weight[e])) continue;
    sets.unite(graph.from[e], graph.to[e]);
    present[graph.from[e]] = present[graph.to[e]] = 1;
  }

  Components found;
  found.of.assign(graph.vertices, Components::kNone);
  for (std::uint32_t v = 0; v < graph.vertices; ++v) {
    if (!present[v]) continue;
    const auto leader = sets.find(v);  // the smallest member, so it was numbered before or is v
    if (leader == v) {
      found.of[v] = found.count();
      found.size.push_back(0);
    } else {
      found.of[v] = found.of[leader];
    }
    ++found.size[found.of[v]];
  }
  found.edges.assign(found.count(), 0);
  for (std::size_t e = 0; e < graph.edges(); ++e) {
    if (reaches(graph.weight[e])) ++found.edges[found.of[graph.from[e]]];
  }
  return found;
}

}  // namespace jam
