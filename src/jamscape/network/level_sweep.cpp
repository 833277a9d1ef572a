#include "jamscape/network/level_sweep.hpp"

#include <cmath>

#include "jamscape/base/error.hpp"
#include "jamscape/network/level_tally.hpp"
#include "jamscape/network/threshold_finder.hpp"
#include "jamscape/network/union_find.hpp"
#include "jamscape/network/validate.hpp"

namespace jam {
namespace {

/// Edges by the number of thresholds below their weight, in the order of their numbers where it is equal.
struct EdgesByLevel {
  std::vector<std::uint32_t> edge;
  std::vector<std::uint32_t> begin;  // of each number of thresholds, and one more
};

EdgesByLevel sort_by_level(std::span<const double> weight, std::span<const double> thresholds) {
  const std::vector<double> above = bars(Level::above, thresholds);
  const ThresholdFinder finder(above);
  EdgesByLevel sorted;
  sorted.begin.assign(thresholds.size() + 2, 0);
  std::vector<std::uint32_t> passed(weight.size());
  for (std::size_t e = 0; e < weight.size(); ++e) {
    passed[e] = static_cast<std::uint32_t>(finder.passed<Level::above>(weight[e]));
    ++sorted.begin[passed[e] + 1];
  }
  for (std::size_t k = 1; k < sorted.begin.size(); ++k) sorted.begin[k] += sorted.begin[k - 1];
  std::vector<std::uint32_t> next(sorted.begin.begin(), sorted.begin.end() - 1);
  sorted.edge.resize(weight.size());
  for (std::size_t e = 0; e < weight.size(); ++e) sorted.edge[next[passed[e]]++] = static_cast<std::uint32_t>(e);
  return sorted;
}

/// `add_edges(k)` adds to the tally those above threshold k and not above the one before.
template <class AddEdges>
std::vector<ClusterLevel> sweep(std::size_t thresholds, LevelTally& tally, const AddEdges& add_edges) {
  std::vector<ClusterLevel> levels(thresholds);
  for (std::size_t k = thresholds; k-- > 0;) {
    add_edges(k);
    levels[k] = tally.level();
  }
  return levels;
}

/// `join(edge)` adds one edge to the sets and the tally. What a threshold sees does not depend on the order of the
/// edges above it.
template <class Join>
std::vector<ClusterLevel> sweep_unsorted(std::span<const double> weight, std::span<const double> thresholds,
                                         LevelTally& tally, const Join& join) {
  const EdgesByLevel sorted = sort_by_level(weight, thresholds);
  return sweep(thresholds.size(), tally, [&](std::size_t k) {
    for (auto e = sorted.begin[k + 1]; e < sorted.begin[k + 2]; ++e) join(sorted.edge[e]);
  });
}

Sides sides_around(const BoxCopy& around, const std::array<std::array<double, 3>, 3>& cell) {
  unsigned sides = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    double shift = 0, scale = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      shift += around[k] * cell[k][a];
      scale += std::abs(around[k] * cell[k][a]);
    }
    if (std::abs(shift) > 1e-9 * scale) sides |= low_side(static_cast<int>(a)) | high_side(static_cast<int>(a));
  }
  return static_cast<Sides>(sides);
}

void check_touches(std::uint32_t vertices, std::span<const Sides> touches) {
  if (!touches.empty() && touches.size() != vertices)
    throw data_error("the sides that vertices touch are not one entry a vertex");
}

void check_thresholds(std::span<const double> thresholds) {
  for (std::size_t k = 1; k < thresholds.size(); ++k)
    if (!(thresholds[k - 1] < thresholds[k])) throw usage_error("the thresholds of a sweep must increase");
}

}  // namespace

std::vector<ClusterLevel> level_sweep(const WeightedGraph& graph, std::span<const double> thresholds,
                                      const BoxSides& box) {
  validate_edges(graph);
  check_touches(graph.vertices, box.touches);
  check_thresholds(thresholds);
  if (!box.image.empty() && box.image.size() != graph.edges())
    throw data_error("the images of edges are not one entry an edge");
  LevelTally tally(graph.vertices);
  for (std::uint32_t v = 0; v < box.touches.size(); ++v) tally.touch(v, box.touches[v]);
  const auto larger = [&](std::uint32_t x, std::uint32_t y) { return tally.size(x) > tally.size(y); };
  if (box.image.empty()) {
    UnionFind sets(graph.vertices);
    return sweep_unsorted(graph.weight, thresholds, tally, [&](std::uint32_t e) {
      const auto merge = sets.unite(graph.from[e], graph.to[e], larger);
      merge.joined() ? tally.join(merge.kept, merge.lost) : tally.add_inner(merge.kept, 1);
    });
  }
  WindingSets sets(graph.vertices);
  return sweep_unsorted(graph.weight, thresholds, tally, [&](std::uint32_t e) {
    const auto merge = sets.unite(graph.from[e], graph.to[e], box.image[e], larger);
    if (merge.joined()) return tally.join(merge.kept, merge.lost);
    tally.add_inner(merge.kept, 1);
    tally.add_sides(merge.kept, sides_around(merge.around, box.cell));
  });
}

std::vector<ClusterLevel> level_sweep(const ComponentHistory& history, std::span<const double> thresholds,
                                      std::span<const Sides> touches) {
  check_touches(history.graph().vertices, touches);
  check_thresholds(thresholds);
  const auto& names = history.vertices().name;
  LevelTally tally(names.size());  // by place
  if (!touches.empty())
    for (std::uint32_t place = 0; place < names.size(); ++place) tally.touch(place, touches[names[place]]);
  const std::vector<double> above = bars(Level::above, thresholds);
  std::uint32_t rank = 0;
  std::vector<UnionFind::Merge> joins(history.edges() + 1);
  return sweep(thresholds.size(), tally, [&](std::size_t k) {
    std::size_t count = 0;  // of the edges that join; put aside, as no processor could guess which do
    for (; rank < history.edges() && history.weight(rank) > above[k]; ++rank) {
      const auto merge = history.merges()[rank];
      tally.add_inner(merge.kept, !merge.joined());
      joins[count] = merge;
      count += merge.joined();
    }
    for (std::size_t m = 0; m < count; ++m) tally.join(joins[m].kept, joins[m].lost);
  });
}

}  // namespace jam
