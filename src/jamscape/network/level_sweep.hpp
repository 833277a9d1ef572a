// The clusters of a weighted graph at many thresholds, from one sweep over its edges from strong to weak.
//
// At threshold t the edges with weight > t are kept (S2; Level::above, whose margin at t is that of base/border.hpp). A
// cluster is a connected piece with at least one edge, so a vertex without an edge above t is in none, at t = 0 too.
// With sides of a box given, a cluster percolates along an axis where its vertices touch both sides, or where it winds
// around a periodic box.
//
//   shape = (1/clusters) sum over clusters, percolating ones included, of edges/vertices:
//           (n - 1)/n for an open path of n vertices, 1 for a ring, more for anything denser (S2 Sec. 5.2)
//
// Union-find keeps vertices, edges and sides of each cluster while edges are added; a threshold costs its row only.
// Cost: about 30 ns an edge; edges are sorted by threshold only. Source: S2 Sec. 4.2, 4.3, 5.2; theory sec. 4.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "jamscape/network/component_history.hpp"
#include "jamscape/network/graph.hpp"
#include "jamscape/network/winding_sets.hpp"

namespace jam {

/// Sides of a box that a vertex touches, a bit each: x low, x high, y low, y high, z low, z high.
using Sides = std::uint8_t;

constexpr Sides low_side(int axis) { return static_cast<Sides>(1u << (2 * axis)); }
constexpr Sides high_side(int axis) { return static_cast<Sides>(2u << (2 * axis)); }

struct ClusterLevel {
  std::uint32_t clusters = 0;              ///< that do not percolate
  std::uint32_t cluster_vertices = 0;      ///< vertices in them
  std::uint32_t percolating_clusters = 0;  ///< along any axis
  std::uint32_t percolating_vertices = 0;  ///< vertices in them
  std::array<bool, 3> percolates{};        ///< whether some cluster percolates along x, y, z
  double shape = 0;                        ///< 0 without clusters

  friend bool operator==(const ClusterLevel&, const ClusterLevel&) = default;
};

/// What a box adds to a graph; empty spans where it adds nothing.
struct BoxSides {
  std::span<const Sides> touches;  ///< one entry a vertex
  std::span<const BoxCopy> image;  ///< one entry an edge: the copy of `to` that is linked to `from`
  /// The edges of the periodic cell along which copies are counted: a cluster percolates along an axis where it winds
  /// by a shift along it.
  std::array<std::array<double, 3>, 3> cell = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
};

/// One entry a threshold. Throws a data error for a graph that breaks the rules of validate_edges() or spans of other
/// lengths, and a usage error where the thresholds do not increase.
std::vector<ClusterLevel> level_sweep(const WeightedGraph& graph, std::span<const double> thresholds,
                                      const BoxSides& box = {});

/// The same for a graph whose components are known already, in a box that is not periodic.
std::vector<ClusterLevel> level_sweep(const ComponentHistory& history, std::span<const double> thresholds,
                                      std::span<const Sides> touches = {});

}  // namespace jam
