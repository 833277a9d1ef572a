// The cliques of one dimension k >= 2, in filtration order, and what is known about each cell's partner.
#pragma once

#include <cstdint>
#include <vector>

namespace jam {

/// What is known about a cell: the cell that ends the class it begins, or one of these. Cell numbers are below 2^31;
/// the number of an ending cell that enters with the same edge carries the bit kAtOnce.
enum Partner : std::uint32_t {
  kUnpaired = 0xFFFFFFFFu,  ///< begins a class that nothing ends (as far as is known yet)
  kNegative = 0xFFFFFFFEu,  ///< ends a class of the dimension below
  kCleared = 0xFFFFFFFDu,   ///< begins a class that is of no interest
  kAtOnce = 0x80000000u,
};

struct Cliques {
  std::uint32_t dimension = 2;
  std::vector<std::uint32_t> facets;  ///< k + 1 a clique: cells of dimension k - 1, the youngest first
  std::vector<std::uint32_t> others;  ///< k - 1 a clique: its vertices outside the youngest edge, increasing
  std::vector<std::uint32_t> group;   ///< of each rank with cliques: its first; kept only where the next dimension asks
  std::vector<std::uint32_t> partner;  ///< one a clique

  std::uint32_t count() const { return static_cast<std::uint32_t>(partner.size()); }
  const std::uint32_t* facets_of(std::uint32_t clique) const {
    return facets.data() + std::size_t{clique} * (dimension + 1);
  }
  const std::uint32_t* others_of(std::uint32_t clique) const {
    return others.data() + std::size_t{clique} * (dimension - 1);
  }

  void clear() {
    facets.clear();
    others.clear();
    group.clear();
    partner.clear();
  }
};

}  // namespace jam
