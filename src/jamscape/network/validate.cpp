#include "jamscape/network/validate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

constexpr std::size_t kLimit = std::size_t{1} << 31;

std::string name_edge(const WeightedGraph& g, std::size_t e) {
  return fmt::format("edge {} ({} - {}, weight {})", e, g.from[e], g.to[e], g.weight[e]);
}

[[noreturn]] void explain(const WeightedGraph& g, std::size_t e) {
  const auto edge = name_edge(g, e);
  if (g.from[e] >= g.vertices || g.to[e] >= g.vertices) {
    throw data_error(fmt::format("{} names a vertex that does not exist: the graph has {} vertices", edge, g.vertices),
                     {}, "count vertices from 0, and give their number if the last ones have no edge");
  }
  if (g.from[e] == g.to[e]) {
    throw data_error(fmt::format("{} joins a vertex to itself", edge), {}, "remove it: a grain does not touch itself");
  }
  throw data_error(fmt::format("{} has no usable weight: it must be finite and not negative", edge), {},
                   "use the magnitude of the force; check the run that made it");
}

bool good(double weight) { return (weight >= 0) & (weight <= std::numeric_limits<double>::max()); }

}  // namespace

void validate_edges(const WeightedGraph& g) {
  const std::size_t n = g.edges();
  if (g.from.size() != n || g.to.size() != n) {
    throw data_error(
        fmt::format("the graph has {} weights but {} and {} ends of edges", n, g.from.size(), g.to.size()));
  }
  if (n >= kLimit || g.vertices >= kLimit) {
    throw data_error(fmt::format(
        "the graph is too large: {} vertices, {} edges; fewer than 2^31 of each can be handled", g.vertices, n));
  }
  // All at once, in loops that fill vector registers: nothing wrong is expected.
  const std::uint32_t last = g.vertices - 1;
  std::uint32_t outside = 0, loops = 0;  // a sign bit where an end is no vertex: negative, or above the last
  for (std::size_t e = 0; e < n; ++e) {
    const std::uint32_t a = g.from[e], b = g.to[e];
    outside |= a | b | (last - a) | (last - b);
    loops |= static_cast<std::uint32_t>(a == b);
  }
  double wrong_weights = 0;
  for (const double w : g.weight) wrong_weights = good(w) ? wrong_weights : 1;
  if (outside >> 31 == 0 && loops == 0 && wrong_weights == 0) return;
  for (std::size_t e = 0;; ++e) {
    const bool ends = g.from[e] < g.vertices && g.to[e] < g.vertices && g.from[e] != g.to[e];
    if (!ends || !good(g.weight[e])) explain(g, e);
  }
}

void validate(const WeightedGraph& g) {
  validate_edges(g);
  const std::size_t n = g.edges();
  std::vector<std::size_t> begin(std::size_t{g.vertices} + 2, 0);
  for (std::size_t e = 0; e < n; ++e) ++begin[std::min(g.from[e], g.to[e]) + 2];
  for (std::size_t v = 2; v < begin.size(); ++v) begin[v] += begin[v - 1];
  std::vector<std::uint32_t> edge(n);
  for (std::size_t e = 0; e < n; ++e) edge[begin[std::min(g.from[e], g.to[e]) + 1]++] = static_cast<std::uint32_t>(e);

  std::vector<std::uint32_t> met_in(g.vertices, 0xFFFFFFFFu);  // the edge that joins this vertex to the present one
  for (std::uint32_t v = 0; v < g.vertices; ++v) {
    for (std::size_t k = begin[v]; k < begin[v + 1]; ++k) {
      const auto other = std::max(g.from[edge[k]], g.to[edge[k]]);
      if (met_in[other] != 0xFFFFFFFFu) {
        throw data_error(
            fmt::format("{} joins the same two vertices as {}", name_edge(g, edge[k]), name_edge(g, met_in[other])), {},
            "give each pair of vertices one edge, for example the sum of its contacts");
      }
      met_in[other] = edge[k];
    }
    for (std::size_t k = begin[v]; k < begin[v + 1]; ++k)
      met_in[std::max(g.from[edge[k]], g.to[edge[k]])] = 0xFFFFFFFFu;
  }
}

}  // namespace jam
