#include "jamscape/network/level_sweep.hpp"

#include <bit>

#include "jamscape/base/error.hpp"
#include "jamscape/network/edge_order.hpp"
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
  void take(std::uint32_t vertices, std::uint32_t edges) {
    edges_[vertices] -= edges;
    if (edges_[vertices] == 0) used_[vertices / 64] &= ~(std::uint64_t{1} << (vertices % 64));
  }
  double sum() const {
    double s = 0;
    for (std::size_t word = 0; word < used_.size(); ++word)
      for (auto bits = used_[word]; bits != 0; bits &= bits - 1) {
        const auto vertices = 64 * word + static_cast<std::size_t>(std::countr_zero(bits));
        s += static_cast<double>(edges_[vertices]) / static_cast<double>(vertices);
      }
    return s;
  }

 private:
  std::vector<std::uint32_t> edges_;  // by number of vertices of the cluster
  std::vector<std::uint64_t> used_;   // a bit for each entry that is not 0
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

  ClusterLevel level() const {
    ClusterLevel now = now_;
    const auto all = now.clusters + now.percolating_clusters;
    if (all > 0) now.shape = shapes_.sum() / all;
    return now;
  }

 private:
  void take(const Cluster& c) {
    if (c.edges == 0) return;
    const bool through = joined(c.sides) != 0;
    --(through ? now_.percolating_clusters : now_.clusters);
    (through ? now_.percolating_vertices : now_.cluster_vertices) -= c.vertices;
    shapes_.take(c.vertices, c.edges);
  }
  void put(const Cluster& c) {
    const unsigned axes = joined(c.sides);
    for (std::size_t a = 0; axes != 0 && a < 3; ++a)
      now_.percolates[a] = now_.percolates[a] || (axes >> (2 * a) & 1u) != 0;
    ++(axes != 0 ? now_.percolating_clusters : now_.clusters);
    (axes != 0 ? now_.percolating_vertices : now_.cluster_vertices) += c.vertices;
    shapes_.add(c.vertices, c.edges);
  }

  std::vector<Cluster> clusters_;  // by leader
  ShapeSum shapes_;
  ClusterLevel now_;
};

/// `join(edge, tally)` adds one edge to the sets and the tally.
template <class Join>
std::vector<ClusterLevel> sweep(const WeightedGraph& graph, std::span<const double> thresholds, Tally tally,
                                const Join& join) {
  EdgeOrder order;
  order.sort(graph.weight);
  std::vector<ClusterLevel> levels(thresholds.size());
  std::size_t rank = 0;
  for (std::size_t k = thresholds.size(); k-- > 0;) {
    for (; rank < order.size() && order.weight(rank) > thresholds[k]; ++rank) join(order.edge(rank), tally);
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
