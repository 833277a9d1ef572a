#include "jamscape/network/level_sweep.hpp"

#include <bit>

#include "jamscape/base/error.hpp"
#include "jamscape/network/threshold_finder.hpp"
#include "jamscape/network/union_find.hpp"
#include "jamscape/network/validate.hpp"

namespace jam {
namespace {

constexpr unsigned kLowSides = 0b010101;

/// Axes along which both sides are touched, as the bits of their low sides.
unsigned joined(Sides sides) { return sides & (sides >> 1) & kLowSides; }

/// Sum of edges/vertices over clusters, from whole numbers: the edges of all clusters of a size. No rounding piles up
/// while clusters come and go, and the sum does not depend on their order.
class ShapeSum {
 public:
  explicit ShapeSum(std::size_t vertices) : edges_(vertices + 1, 0), used_(vertices / 64 + 1, 0) {}

  void add(std::uint32_t vertices, std::uint32_t edges) {
    edges_[vertices] += edges;
    used_[vertices / 64] |= std::uint64_t{1} << (vertices % 64);
  }
  void add_edge(std::uint32_t vertices) { ++edges_[vertices]; }  // to a cluster that counts already
  void take(std::uint32_t vertices, std::uint32_t edges) { edges_[vertices] -= edges; }
  double sum() {
    double s = 0;
    for (std::size_t word = 0; word < used_.size(); ++word)
      for (auto bits = used_[word]; bits != 0; bits &= bits - 1) {
        const auto vertices = 64 * word + static_cast<std::size_t>(std::countr_zero(bits));
        if (edges_[vertices] == 0) used_[word] ^= bits & (0 - bits);
        s += static_cast<double>(edges_[vertices]) / static_cast<double>(vertices);
      }
    return s;
  }

 private:
  std::vector<std::uint32_t> edges_;  // by number of vertices of the cluster
  std::vector<std::uint64_t> used_;   // a bit for each entry that may not be 0
};

struct Cluster {
  std::uint32_t vertices = 1, edges = 0;
  Sides sides = 0;
};

class Tally {
 public:
  explicit Tally(const WeightedGraph& graph, std::span<const Sides> touches)
      : clusters_(graph.vertices), shapes_(graph.vertices) {
    for (std::size_t v = 0; v < touches.size(); ++v) clusters_[v].sides = touches[v];
  }

  std::uint32_t size(std::uint32_t leader) const { return clusters_[leader].vertices; }

  /// An edge has been added: within one cluster (kept == lost) or between two. `sides` are touched by it.
  void add_edge(std::uint32_t kept, std::uint32_t lost, Sides sides) {
    Cluster& c = clusters_[kept];
    if (kept == lost && (c.sides | sides) == c.sides && c.edges > 0) {
      ++c.edges;
      return shapes_.add_edge(c.vertices);
    }
    take(c);
    if (kept != lost) {
      const Cluster& other = clusters_[lost];
      take(other);
      c.vertices += other.vertices;
      c.edges += other.edges;
      c.sides |= other.sides;
    }
    ++c.edges;
    c.sides |= sides;
    put(c);
  }

  ClusterLevel level() {
    ClusterLevel now;
    now.clusters = count_ - through_count_;
    now.cluster_vertices = vertices_ - through_vertices_;
    now.percolating_clusters = through_count_;
    now.percolating_vertices = through_vertices_;
    for (std::size_t a = 0; a < 3; ++a) now.percolates[a] = (through_ >> (2 * a) & 1u) != 0;
    const auto all = now.clusters + now.percolating_clusters;
    if (all > 0) now.shape = shapes_.sum() / all;
    return now;
  }

 private:
  void take(const Cluster& c) {
    const std::uint32_t there = c.edges > 0;  // a branch would be wrong too often
    count_ -= there;
    vertices_ -= there * c.vertices;
    if (joined(c.sides) != 0) {
      through_count_ -= there;
      through_vertices_ -= there * c.vertices;
    }
    shapes_.take(c.vertices, c.edges);
  }
  void put(const Cluster& c) {
    ++count_;
    vertices_ += c.vertices;
    if (const unsigned axes = joined(c.sides); axes != 0) {
      through_ |= axes;
      ++through_count_;
      through_vertices_ += c.vertices;
    }
    shapes_.add(c.vertices, c.edges);
  }

  std::vector<Cluster> clusters_;  // by leader
  ShapeSum shapes_;
  std::uint32_t count_ = 0, vertices_ = 0;                  // clusters, and vertices in them
  std::uint32_t through_count_ = 0, through_vertices_ = 0;  // of those that percolate
  unsigned through_ = 0;                                    // axes along which some cluster percolates
};

/// Edges by the number of thresholds below their weight, in the order of their numbers where it is equal.
struct EdgesByLevel {
  std::vector<std::uint32_t> edge;
  std::vector<std::uint32_t> begin;  // of each number of thresholds, and one more
};

EdgesByLevel sort_by_level(std::span<const double> weight, std::span<const double> thresholds) {
  const ThresholdFinder finder(thresholds);
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

/// `join(edge, tally)` adds one edge to the sets and the tally. What a threshold sees does not depend on the order of
/// the edges above it.
template <class Join>
std::vector<ClusterLevel> sweep(const WeightedGraph& graph, std::span<const double> thresholds, Tally tally,
                                const Join& join) {
  const EdgesByLevel sorted = sort_by_level(graph.weight, thresholds);
  std::vector<ClusterLevel> levels(thresholds.size());
  for (std::size_t k = thresholds.size(); k-- > 0;) {
    for (auto e = sorted.begin[k + 1]; e < sorted.begin[k + 2]; ++e) join(sorted.edge[e], tally);
    levels[k] = tally.level();
  }
  return levels;
}

Sides sides_around(const BoxCopy& around) {
  unsigned sides = 0;
  for (int a = 0; a < 3; ++a)
    if (around[static_cast<std::size_t>(a)] != 0) sides |= low_side(a) | high_side(a);
  return static_cast<Sides>(sides);
}

void check(const WeightedGraph& graph, std::span<const double> thresholds, const BoxSides& box) {
  validate_edges(graph);
  if (!box.touches.empty() && box.touches.size() != graph.vertices)
    throw data_error("the sides that vertices touch are not one entry a vertex");
  if (!box.image.empty() && box.image.size() != graph.edges())
    throw data_error("the images of edges are not one entry an edge");
  for (std::size_t k = 1; k < thresholds.size(); ++k)
    if (!(thresholds[k - 1] < thresholds[k])) throw usage_error("the thresholds of a sweep must increase");
}

}  // namespace

std::vector<ClusterLevel> level_sweep(const WeightedGraph& graph, std::span<const double> thresholds,
                                      const BoxSides& box) {
  check(graph, thresholds, box);
  const auto larger = [](const Tally& tally) {
    return [&tally](std::uint32_t x, std::uint32_t y) { return tally.size(x) > tally.size(y); };
  };
  if (box.image.empty()) {
    UnionFind sets(graph.vertices);
    return sweep(graph, thresholds, Tally(graph, box.touches), [&](std::uint32_t e, Tally& tally) {
      const auto merge = sets.unite(graph.from[e], graph.to[e], larger(tally));
      tally.add_edge(merge.kept, merge.lost, 0);
    });
  }
  WindingSets sets(graph.vertices);
  return sweep(graph, thresholds, Tally(graph, box.touches), [&](std::uint32_t e, Tally& tally) {
    const auto merge = sets.unite(graph.from[e], graph.to[e], box.image[e], larger(tally));
    tally.add_edge(merge.kept, merge.lost, sides_around(merge.around));
  });
}

}  // namespace jam
