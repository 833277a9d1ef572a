// Which cliques does an edge close? Those of the edge and any clique among the common neighbours of its ends, all links
// older. Called rank by rank, so that cliques come out in filtration order, with their facets.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "jamscape/topology/cliques.hpp"
#include "jamscape/topology/older_graph.hpp"

namespace jam {

class CliqueBuilder {
 public:
  /// Cliques of dimension 2..dimension are kept in `into`. Both references must outlive the builder's use.
  CliqueBuilder(const OlderGraph& graph, std::span<const Ends> ends, std::uint32_t dimension,
                std::vector<Cliques>& into);

  /// All cliques closed by an edge with these common neighbours, rank by rank. A clique of the last dimension
  /// that certainly begins a class, being the youngest facet of a clique one dimension up, is marked kCleared.
  void add(std::uint32_t rank, std::span<const CommonNeighbour> common);

 private:
  std::uint32_t link(std::size_t i, std::size_t j) const { return links_[i * common_.size() + j]; }
  void choose(std::uint32_t dimension, std::size_t next);
  void add_larger(std::uint32_t dimension);
  bool begins_class() const;
  std::uint32_t facet_of_group(std::uint32_t dimension, std::size_t left_out);
  std::uint32_t facet_without_end(std::uint32_t dimension, bool without_a);
  std::uint32_t find(std::uint32_t dimension, std::uint32_t rank, std::span<const std::uint32_t> others) const;

  const OlderGraph& graph_;
  std::span<const Ends> ends_;
  std::uint32_t dimension_;
  std::vector<Cliques>& cliques_;  // dimension k at k - 2

  std::uint32_t rank_ = 0;
  std::span<const CommonNeighbour> common_;
  std::vector<std::uint32_t> links_;   // matrix over common_: rank of the link between two of them, or none
  std::vector<std::size_t> chosen_;    // indices into common_, increasing: the clique under construction
  std::vector<std::uint32_t> others_;  // vertices, for lookups
};

}  // namespace jam
