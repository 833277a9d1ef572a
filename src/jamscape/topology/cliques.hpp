// The cliques of one dimension k >= 2, in filtration order, and what is known about each cell's partner.
#pragma once

#include <cstdint>
#include <vector>

namespace jam {

/// The partner of a cell that begins a class is the cell that ends it; these stand where there is none.
enum Partner : std::uint32_t {
  kUnpaired = 0xFFFFFFFFu,  ///< begins a class that nothing ends (as far as is known yet)
  kNegative = 0xFFFFFFFEu,  ///< ends a class of the dimension below
  kCleared = 0xFFFFFFFDu,   ///< begins a class that is of no interest
};

struct Cliques {
  std::uint32_t dimension = 2;
  std::vector<std::uint32_t>
      facets;  ///< k + 1 a clique: cells of dimension k - 1; the first has the same youngest edge
  std::vector<std::uint32_t> others;   ///< k - 1 a clique: its vertices outside the youngest edge, by increasing age
  std::vector<std::uint32_t> group;    ///< of each edge rank: its first clique; kept only where the next dimension asks
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
