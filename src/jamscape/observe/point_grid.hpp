// Points sorted into equal cells, so that those within a distance of a place are found without looking at all.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "jamscape/geometry/vec.hpp"

namespace jam {

class PointGrid {
 public:
  /// Cells of about `side`, never more than a few per point.
  PointGrid(const std::vector<Vec3>& points, double side);

  /// Calls visit(r2) with the squared distance of every point closer to `centre` than `range`.
  template <class Visit>
  void each_within(const Vec3& centre, double range, Visit&& visit) const {
    std::array<std::int64_t, 3> first{}, last{};
    for (int a = 0; a < 3; ++a) {
      const auto k = static_cast<std::size_t>(a);
      first[k] = cell(a, centre[a] - range);
      last[k] = cell(a, centre[a] + range);
    }
    const double limit = range * range;
    for (std::int64_t cz = first[2]; cz <= last[2]; ++cz)
      for (std::int64_t cy = first[1]; cy <= last[1]; ++cy) {
        const std::int64_t row = (cz * cells_[1] + cy) * cells_[0];  // cells of a row lie one after another
        const std::uint32_t end = begin_[static_cast<std::size_t>(row + last[0] + 1)];
        for (std::uint32_t p = begin_[static_cast<std::size_t>(row + first[0])]; p < end; ++p) {
          const double dx = x_[p] - centre[0], dy = y_[p] - centre[1], dz = z_[p] - centre[2];
          const double r2 = dx * dx + dy * dy + dz * dz;
          if (r2 < limit) visit(r2);
        }
      }
  }

 private:
  std::int64_t cell(int axis, double at) const {
    const auto k = static_cast<std::size_t>(axis);
    const double c = (at - lo_[axis]) * inverse_side_[k];
    if (!(c > 0)) return 0;
    return c < static_cast<double>(cells_[k]) ? static_cast<std::int64_t>(c) : cells_[k] - 1;
  }

  Vec3 lo_{};
  std::array<double, 3> inverse_side_{};
  std::array<std::int64_t, 3> cells_{1, 1, 1};
  std::vector<std::uint32_t> begin_;  // of each cell; one more than there are cells
  std::vector<double> x_, y_, z_;     // in the order of the cells
};

}  // namespace jam
