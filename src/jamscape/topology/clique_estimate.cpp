#include "jamscape/topology/clique_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <vector>

namespace jam {
namespace {

constexpr double small_bytes = 1e9;
constexpr double bytes_an_edge = 200;  // contact networks of spheres stay below
constexpr double spare = 1.2;          // arrays that grow have room to grow
constexpr std::size_t edges_looked_at = 4096;
constexpr int choices_looked_at = 64;

double bytes_of(int dimension) { return spare * 4 * (2 * dimension + 1); }  // facets, other vertices, partner

double choose(double n, int k) {
  double ways = 1;
  for (int i = 0; i < k; ++i) ways *= std::max(0.0, n - i) / (i + 1);
  return ways;
}

using Vertices = std::vector<std::uint32_t>;

std::vector<Vertices> neighbours_of(const WeightedGraph& g) {
  std::vector<Vertices> around(g.vertices);
  for (std::size_t e = 0; e < g.edges(); ++e) {
    around[g.from[e]].push_back(g.to[e]);
    around[g.to[e]].push_back(g.from[e]);
  }
  for (Vertices& v : around) std::sort(v.begin(), v.end());
  return around;
}

bool linked(const std::vector<Vertices>& around, std::uint32_t a, std::uint32_t b) {
  return std::binary_search(around[a].begin(), around[a].end(), b);
}

/// Of random choices of `count` among the common neighbours, the share that is linked throughout.
double linked_share(const std::vector<Vertices>& around, const Vertices& common, int count, std::uint64_t& random) {
  if (count < 2) return 1;
  int whole = 0;
  for (int k = 0; k < choices_looked_at; ++k) {
    Vertices chosen;
    while (static_cast<int>(chosen.size()) < count) {
      random = random * 6364136223846793005u + 1442695040888963407u;
      const std::uint32_t v = common[(random >> 33) % common.size()];
      if (std::find(chosen.begin(), chosen.end(), v) == chosen.end()) chosen.push_back(v);
    }
    bool all = true;
    for (std::size_t a = 0; a < chosen.size() && all; ++a)
      for (std::size_t b = 0; b < a && all; ++b) all = linked(around, chosen[a], chosen[b]);
    whole += all;
  }
  return static_cast<double>(whole) / choices_looked_at;
}

bool well_formed(const WeightedGraph& g) {
  for (std::size_t e = 0; e < g.edges(); ++e)
    if (g.from[e] >= g.vertices || g.to[e] >= g.vertices) return false;
  return g.from.size() == g.to.size();
}

}  // namespace

CliqueEstimate estimate_cliques(const WeightedGraph& graph, const PersistenceOptions& options) {
  CliqueEstimate estimate;
  if (options.triangles == Triangles::keep || options.max_dimension < 1 || !well_formed(graph)) return estimate;
  const int top = options.max_dimension + 1;
  const double limit = std::max(small_bytes, bytes_an_edge * static_cast<double>(graph.edges()));
  // A clique of dimension k has (k + 1) k / 2 edges and k - 1 vertices beside the two of each.
  const auto add = [&](double common, double share, int k, double times) {
    const double cliques = times * share * choose(common, k - 1) / (k * (k + 1) / 2.0);
    estimate.cliques += cliques;
    estimate.bytes += cliques * bytes_of(k);
  };
  std::vector<std::uint32_t> degree(graph.vertices, 0);
  for (std::size_t e = 0; e < graph.edges(); ++e) {
    ++degree[graph.from[e]];
    ++degree[graph.to[e]];
  }
  for (std::size_t e = 0; e < graph.edges(); ++e)
    for (int k = 2; k <= top; ++k) add(std::min(degree[graph.from[e]], degree[graph.to[e]]) - 1.0, 1, k, 1);
  if (estimate.bytes <= limit) return estimate;

  estimate = {};
  const std::vector<Vertices> around = neighbours_of(graph);
  const std::size_t stride = std::max<std::size_t>(1, graph.edges() / edges_looked_at);
  const std::size_t looked = (graph.edges() + stride - 1) / stride;
  const double times = static_cast<double>(graph.edges()) / static_cast<double>(looked);
  std::uint64_t random = 1;
  for (std::size_t e = 0; e < graph.edges(); e += stride) {
    Vertices common;
    const Vertices &a = around[graph.from[e]], &b = around[graph.to[e]];
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    for (int k = 2; k <= top && static_cast<int>(common.size()) >= k - 1; ++k)
      add(static_cast<double>(common.size()), linked_share(around, common, k - 1, random), k, times);
  }
  estimate.large = estimate.bytes > limit;
  return estimate;
}

}  // namespace jam
