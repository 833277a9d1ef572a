// Pairs cells of dimension k with cells of dimension k + 1 by reducing the boundary matrix over Z/2.
//
// Columns are taken in filtration order. A column whose youngest facet is free is paired at once, without arithmetic:
// on contact networks all but a few are (a triangle ends the loop its own youngest edge has just closed). Columns known
// to begin a class are skipped (clearing: Chen and Kerber 2011), rows known to end one are left out. Reduced columns
// are kept only where they differ from the boundary.
#pragma once

#include <cstdint>
#include <vector>

#include "jamscape/topology/bit_column.hpp"
#include "jamscape/topology/cliques.hpp"

namespace jam {

class Reduction {
 public:
  /// `rows`: one partner a cell of dimension k; free ones that a column ends get its index. The columns' partners
  /// become kNegative where they end a class. Call for the highest dimension first, so that clearing works.
  void pair(Cliques& columns, std::vector<std::uint32_t>& rows);

 private:
  void add_boundary(const Cliques& columns, std::uint32_t column, const std::vector<std::uint32_t>& rows);
  void add_column(const Cliques& columns, std::uint32_t partner, const std::vector<std::uint32_t>& rows);

  BitColumn work_;
  std::vector<std::uint32_t> reduced_;  // columns whose reduced form is kept, increasing
  std::vector<std::size_t> begin_;      // of each, and one more: into entries_
  std::vector<std::uint32_t> entries_;  // rows of the reduced columns
};

}  // namespace jam
