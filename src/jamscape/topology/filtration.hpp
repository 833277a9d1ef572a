// The clique complex of a weighted graph in the order in which its cells enter as the threshold falls, and its H0.
//
// Edges are named by their rank (0 = heaviest). A clique enters with its youngest edge, so cliques are found edge by
// edge among the common neighbours that older edges give its two ends, and need no sorting. An edge that joins two
// components closes no clique and needs no search; on contact networks these are up to half of all edges.
//
// Cells of equal value enter by increasing index: vertices by their number, edges by theirs, cliques by their youngest
// edge and then by their other vertices.
//
// Each of the two passes reads in sequence what it can and asks the cache early for the rest (edges in order of weight
// are scattered over the packing), so the cost per edge grows little once the network has left the cache.
#pragma once

#include <cstdint>
#include <vector>

#include "jamscape/network/edge_order.hpp"
#include "jamscape/network/graph.hpp"
#include "jamscape/network/union_find.hpp"
#include "jamscape/topology/cliques.hpp"
#include "jamscape/topology/older_graph.hpp"

namespace jam {

/// Whether memory that only Filtration::build() needs is kept for the next call, or given back early: a third of all.
enum class Memory { keep, release };

class Filtration {
 public:
  /// Vertices that have edges, in the order in which they enter.
  struct Vertices {
    std::vector<std::uint32_t> name;  ///< in the graph
    std::vector<std::uint32_t>
        entry;  ///< rank of the first edge of the vertex's value (any vertex of that edge has it)
    std::vector<std::uint32_t> partner;  ///< the edge that ends its component, or kUnpaired

    std::size_t size() const { return name.size(); }
  };

  /// Ranks the edges, pairs vertices with edges, finds the cliques up to `dimension` (below 2: none).
  /// Throws a data error for a graph that breaks the rules of validate().
  void build(const WeightedGraph& graph, int dimension, Memory memory);

  std::uint32_t edges() const { return static_cast<std::uint32_t>(order_.size()); }
  std::uint32_t edge(std::uint32_t rank) const { return order_.edge(rank); }
  double weight(std::uint32_t rank) const { return order_.weight(rank); }
  Ends ends(std::uint32_t rank) const { return ends_[rank]; }

  const Vertices& vertices() const { return vertices_; }
  /// Vertices without edges, by increasing number.
  const std::vector<std::uint32_t>& isolated() const { return isolated_; }

  /// The youngest edge of a cell of dimension >= 1: its value is that edge's weight.
  std::uint32_t youngest_edge(std::uint32_t dimension, std::uint32_t cell) const;

  /// One an edge, by rank: kNegative where it joins components; else a triangle, written by the reduction, or
  /// kUnpaired.
  std::vector<std::uint32_t> edge_partner;
  /// Cliques of dimension 2, 3, ...
  std::vector<Cliques> cliques;

 private:
  void rank_edges(const WeightedGraph& graph);
  void order_vertices();
  void find_components();
  void find_cliques(const WeightedGraph& graph, std::uint32_t dimension);

  EdgeOrder order_;
  std::vector<Ends> ends_;             // by rank
  std::vector<std::uint32_t> degree_;  // by vertex
  std::vector<std::uint32_t> place_;   // by vertex: index into vertices_
  Vertices vertices_;
  std::vector<std::uint32_t> isolated_;
  UnionFind sets_;  // by place: the smaller is older
  OlderGraph older_;
  std::vector<CommonNeighbour> common_;
};

}  // namespace jam
