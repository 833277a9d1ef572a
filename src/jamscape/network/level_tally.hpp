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
  /// To a cluster that has been added, or to a vertex that will be taken before the next sum.
  void add_edges(std::uint32_t vertices, std::uint32_t edges) { edges_[vertices] += edges; }
  void take(std::uint32_t vertices, std::uint32_t edges) { edges_[vertices] -= edges; }
  double sum();

 private:
  std::vector<std::uint32_t> edges_;  // by number of vertices of the cluster
  std::vector<std::uint64_t> used_;   // a bit for each entry that may not be 0
};

/// Pieces are named by a leader; a piece of one vertex is no cluster.
class LevelTally {
 public:
  explicit LevelTally(std::size_t vertices) : pieces_(vertices), shapes_(vertices) {}

  /// Before the vertex has an edge.
  void touch(std::uint32_t vertex, Sides sides) { pieces_[vertex].sides = sides; }

  std::uint32_t size(std::uint32_t leader) const { return pieces_[leader].vertices; }

  /// Edges within a piece. Those of a piece that is joined together before the next level() may come first, named by
  /// any piece of it.
  void add_inner(std::uint32_t leader, std::uint32_t edges) {
    Piece& p = pieces_[leader];
    p.edges += edges;
    shapes_.add_edges(p.vertices, edges);
  }

  /// An edge between two pieces.
  void join(std::uint32_t kept, std::uint32_t lost) {
    Piece& p = pieces_[kept];
    const Piece a = p, b = pieces_[lost];
    const std::uint32_t newcomers = a.alone() + b.alone();  // a branch would be wrong too often
    count_ += newcomers - 1;
    vertices_ += newcomers;
    shapes_.take(a.vertices, a.edges);
    shapes_.take(b.vertices, b.edges);
    p = {a.vertices + b.vertices, a.edges + b.edges + 1, static_cast<Sides>(a.sides | b.sides)};
    shapes_.add(p.vertices, p.edges);
    if (joined(p.sides) != 0) {
      leave_through(a);
      leave_through(b);
      enter_through(p);
    }
  }

  /// A cluster winds around the box.
  void add_sides(std::uint32_t leader, Sides sides) {
    Piece& p = pieces_[leader];
    leave_through(p);
    p.sides |= sides;
    enter_through(p);
  }

  ClusterLevel level();

 private:
  struct Piece {
    std::uint32_t vertices = 1, edges = 0;
    Sides sides = 0;

    bool alone() const { return vertices == 1; }
    bool percolates() const { return !alone() && joined(sides) != 0; }
  };

  void leave_through(const Piece& p) {
    through_count_ -= p.percolates();
    through_vertices_ -= p.percolates() ? p.vertices : 0;
  }
  void enter_through(const Piece& p) {
    through_ |= joined(p.sides);
    through_count_ += p.percolates();
    through_vertices_ += p.percolates() ? p.vertices : 0;
  }

  std::vector<Piece> pieces_;  // by leader
  ShapeSum shapes_;
  std::uint32_t count_ = 0, vertices_ = 0;                  // clusters, and vertices in them
  std::uint32_t through_count_ = 0, through_vertices_ = 0;  // of those that percolate
  unsigned through_ = 0;                                    // axes along which some cluster percolates
};

}  // namespace jam
