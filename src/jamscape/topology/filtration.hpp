// The clique complex of a weighted graph in the order in which its cells enter as the threshold falls, and its H0.
//
// Edges are named by their rank (0 = heaviest), vertices by their age (0 = enters first). A clique enters with its
// youngest edge, so cliques are found edge by edge among the common neighbours that older edges give its two ends, and
// need no sorting. An edge that joins two components closes no clique and needs no search; on contact networks these
// are up to half of all edges.
//
// Cells of equal value enter by increasing index: vertices by their number, edges by theirs, cliques by their youngest
// edge and then by the ages of their other vertices.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "jamscape/network/edge_order.hpp"
#include "jamscape/network/graph.hpp"
#include "jamscape/network/union_find.hpp"
#include "jamscape/topology/cliques.hpp"
#include "jamscape/topology/older_graph.hpp"

namespace jam {

class Filtration {
 public:
  /// Ranks the edges, ages the vertices, pairs vertices with edges, finds the cliques up to `dimension` (below 2:
  /// none). Throws a data error for a graph that breaks the rules of validate(). Keeps its memory between calls.
  void build(const WeightedGraph& graph, int dimension);

  std::uint32_t edges() const { return static_cast<std::uint32_t>(ends_.size()); }
  /// Vertices that have an edge; the others are isolated and have no age.
  std::uint32_t vertices() const { return static_cast<std::uint32_t>(vertex_.size()); }

  std::uint32_t edge(std::uint32_t rank) const { return order_.edge(rank); }
  Ends ends(std::uint32_t rank) const { return ends_[rank]; }
  std::uint32_t vertex(std::uint32_t age) const { return vertex_[age]; }
  /// The rank of an edge whose weight is the vertex's value.
  std::uint32_t entry(std::uint32_t age) const { return entry_[age]; }
  bool isolated(std::uint32_t vertex) const { return age_of_[vertex] == kNoAge; }

  /// The youngest edge of a cell of dimension >= 1: its value is that edge's weight.
  std::uint32_t youngest_edge(std::uint32_t dimension, std::uint32_t cell) const;

  /// One a vertex, by age: the edge that ends its component, or kUnpaired.
  std::vector<std::uint32_t> vertex_partner;
  /// One an edge, by rank: kNegative where it joins components; else a triangle, written by the reduction, or
  /// kUnpaired.
  std::vector<std::uint32_t> edge_partner;
  /// Cliques of dimension 2, 3, ...
  std::vector<Cliques> cliques;

 private:
  static constexpr std::uint32_t kNoAge = 0xFFFFFFFFu;

  void age_vertices(const WeightedGraph& graph);
  void sweep(const WeightedGraph& graph, std::uint32_t dimension);

  EdgeOrder order_;
  std::vector<Ends> ends_;                     // by rank
  std::vector<std::uint32_t> vertex_, entry_;  // by age
  std::vector<std::uint32_t> age_of_;          // by vertex
  UnionFind sets_;
  OlderGraph older_;
  std::vector<CommonNeighbour> common_;
};

}  // namespace jam
