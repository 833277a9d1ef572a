// The clique complex of a weighted graph in the order in which its cells enter as the threshold falls, and its H0.
//
// Edges are named by their rank (0 = heaviest). A clique enters with its youngest edge, so cliques are found edge by
// edge among the common neighbours that older edges give its two ends, and need no sorting. An edge that joins two
// components closes no clique and needs no search; on contact networks these are up to half of all edges.
//
// Cells of equal value enter by increasing index: vertices by their number, edges by theirs, cliques by their youngest
// edge and then by their other vertices.
#pragma once

#include <cstdint>
#include <vector>

#include "jamscape/network/component_history.hpp"
#include "jamscape/topology/cliques.hpp"
#include "jamscape/topology/older_graph.hpp"

namespace jam {

class Filtration {
 public:
  /// H0: pairs vertices with edges. The history must outlive the use of the filtration.
  void pair_components(const ComponentHistory& history);
  /// Finds the cliques up to `dimension` (below 2: none); pair_components() comes first.
  /// Throws a data error for a repeated edge.
  void find_cliques(std::uint32_t dimension);
  /// Gives back the memory that only find_cliques() needs.
  void forget_neighbours();

  std::uint32_t edges() const { return history_->edges(); }
  std::uint32_t edge(std::uint32_t rank) const { return history_->edge(rank); }
  double weight(std::uint32_t rank) const { return history_->weight(rank); }
  Ends ends(std::uint32_t rank) const { return history_->ends()[rank]; }

  /// Vertices that have edges, in the order in which they enter; the rest are isolated.
  const ComponentHistory::Vertices& vertices() const { return history_->vertices(); }
  const std::vector<std::uint32_t>& isolated() const { return history_->isolated(); }

  /// The youngest edge of a cell of dimension >= 1: its value is that edge's weight.
  std::uint32_t youngest_edge(std::uint32_t dimension, std::uint32_t cell) const;

  /// One for each of vertices(): the edge that ends its component, or kUnpaired.
  std::vector<std::uint32_t> vertex_partner;
  /// One an edge, by rank: kNegative where it joins components; else a triangle, written by the reduction, or
  /// kUnpaired.
  std::vector<std::uint32_t> edge_partner;
  /// Cliques of dimension 2, 3, ...
  std::vector<Cliques> cliques;

 private:
  const ComponentHistory* history_ = nullptr;
  OlderGraph older_;
  std::vector<CommonNeighbour> common_;
};

}  // namespace jam
