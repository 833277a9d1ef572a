// The components of a weighted graph while its edges come one by one, from strong to weak: what persistence and sweeps
// over thresholds have in common.
//
// Edges are named by their rank (0 = heaviest; equal weights by their number). A vertex enters with the heaviest of its
// edges, vertices of equal value by their number; its place is how many entered before it. Of two components that an
// edge joins, the one whose first vertex entered later is lost (elder rule).
//
// Each pass reads in sequence what it can and asks the cache early for the rest (edges in order of weight are scattered
// over the packing), so the cost per edge grows little once the graph has left the cache.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "jamscape/network/edge_order.hpp"
#include "jamscape/network/graph.hpp"
#include "jamscape/network/union_find.hpp"

namespace jam {

struct Ends {
  std::uint32_t a, b;
};

class ComponentHistory {
 public:
  /// Vertices that have edges, by place.
  struct Vertices {
    std::vector<std::uint32_t> name;  ///< in the graph
    std::vector<std::uint32_t>
        entry;  ///< rank of the first edge of the vertex's value (any vertex of that edge has it)

    std::size_t size() const { return name.size(); }
  };

  /// Throws a data error for a graph that breaks the rules of validate_edges(). Keeps its memory between calls; the
  /// graph must outlive the use of the result.
  void build(const WeightedGraph& graph);
  void build(WeightedGraph&&) = delete;

  const WeightedGraph& graph() const { return *graph_; }
  std::uint32_t edges() const { return static_cast<std::uint32_t>(order_.size()); }
  std::uint32_t edge(std::uint32_t rank) const { return order_.edge(rank); }
  double weight(std::uint32_t rank) const { return order_.weight(rank); }
  /// By rank.
  std::span<const Ends> ends() const { return ends_; }
  /// Number of edges, one entry a vertex of the graph.
  std::span<const std::uint32_t> degree() const { return degree_; }

  const Vertices& vertices() const { return vertices_; }
  /// Vertices without edges, by increasing number.
  const std::vector<std::uint32_t>& isolated() const { return isolated_; }

  /// By rank: the components that the edge finds at its ends, as the places of their first vertices.
  std::span<const UnionFind::Merge> merges() const { return merges_; }
  /// Gives back the memory of merges() and what was used to find them: half of all.
  void forget_merges();

  /// Edges between asking the cache for what an edge needs and using it. Small graphs are in the cache: never.
  std::uint32_t ahead() const { return edges() < 1u << 15 ? edges() : 16; }

 private:
  void rank_edges();
  void order_vertices();
  void join_components();

  const WeightedGraph* graph_ = nullptr;
  EdgeOrder order_;
  std::vector<Ends> ends_;             // by rank
  std::vector<std::uint32_t> degree_;  // by vertex
  std::vector<std::uint32_t> place_;   // by vertex
  Vertices vertices_;
  std::vector<std::uint32_t> isolated_;
  UnionFind sets_;  // by place: the smaller is older
  std::vector<UnionFind::Merge> merges_;
};

}  // namespace jam
