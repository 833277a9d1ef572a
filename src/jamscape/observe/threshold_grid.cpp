#include "jamscape/observe/threshold_grid.hpp"

#include <cmath>
#include <cstddef>

#include "jamscape/base/border.hpp"

namespace jam {

std::vector<double> threshold_grid(double max, double step) {
  std::vector<double> grid(static_cast<std::size_t>(borders_reached(max / step)) + 1);
  // Through whole numbers where possible, so that the 7th of .05 is .35 and not .35000000000000003.
  const double per_unit = std::round(1 / step);
  const bool whole = std::abs(per_unit * step - 1) < 1e-12;
  for (std::size_t k = 0; k < grid.size(); ++k) {
    const auto i = static_cast<double>(k);
    grid[k] = whole ? i / per_unit : i * step;
  }
  return grid;
}

}  // namespace jam
