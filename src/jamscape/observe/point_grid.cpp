#include "jamscape/observe/point_grid.hpp"

#include <algorithm>
#include <cmath>

namespace jam {

PointGrid::PointGrid(const std::vector<Vec3>& points, double side) {
  if (points.empty()) {
    begin_.assign(2, 0);
    return;
  }
  Vec3 hi = points[0];
  lo_ = points[0];
  for (const Vec3& p : points)
    for (int a = 0; a < 3; ++a) {
      lo_[a] = std::min(lo_[a], p[a]);
      hi[a] = std::max(hi[a], p[a]);
    }
  const double most = 4 * static_cast<double>(points.size()) + 64;
  double cells = 0;
  for (bool fits = false; !fits; side *= 1.5) {
    cells = 1;
    for (int a = 0; a < 3; ++a) cells *= std::floor((hi[a] - lo_[a]) / side) + 1;
    fits = cells <= most;
    if (!fits) continue;
    for (int a = 0; a < 3; ++a) {
      const auto k = static_cast<std::size_t>(a);
      cells_[k] = static_cast<std::int64_t>((hi[a] - lo_[a]) / side) + 1;
      inverse_side_[k] = 1 / side;
    }
  }
  std::vector<std::uint32_t> home(points.size());
  begin_.assign(static_cast<std::size_t>(cells_[0] * cells_[1] * cells_[2]) + 1, 0);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const std::int64_t c =
        (cell(2, points[p][2]) * cells_[1] + cell(1, points[p][1])) * cells_[0] + cell(0, points[p][0]);
    home[p] = static_cast<std::uint32_t>(c);
    ++begin_[home[p] + 1];
  }
  for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (auto* v : {&x_, &y_, &z_}) v->resize(points.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    const std::uint32_t at = next[home[p]]++;
    x_[at] = points[p][0];
    y_[at] = points[p][1];
    z_[at] = points[p][2];
  }
}

}  // namespace jam
