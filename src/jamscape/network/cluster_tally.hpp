// What is known of the clusters of a graph while edges are added, for level_sweep.hpp: how many there are, how large,
// which percolate, and the mean of edges/vertices.
#pragma once

#include <cstdint>
#include <vector>

#include "jamscape/network/level_sweep.hpp"

namespace jam {

/// Axes along which both sides are touched, as the bits of their low sides.
inline unsigned joined(Sides sides) { return sides & (sides >> 1) & 0b010101u; }

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
  double sum();

 private:
  std::vector<std::uint32_t> edges_;  // by number of vertices of the cluster
  std::vector<std::uint64_t> used_;   // a bit for each entry that may not be 0
};

class ClusterTally {
 public:
  explicit ClusterTally(std::size_t vertices) : clusters_(vertices), shapes_(vertices) {}

  /// Before the vertex has an edge.
  void touch(std::uint32_t vertex, Sides sides) { clusters_[vertex].sides = sides; }

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

  ClusterLevel level();

 private:
  struct Cluster {
    std::uint32_t vertices = 1, edges = 0;
    Sides sides = 0;
  };

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

}  // namespace jam
