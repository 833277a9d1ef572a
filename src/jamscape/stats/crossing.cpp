#include "jamscape/stats/crossing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "jamscape/base/border.hpp"
#include "jamscape/base/error.hpp"
#include "jamscape/stats/curves.hpp"

namespace jam {

std::vector<Crossing> crossings(std::span<const double> x, std::span<const double> y, double level) {
  if (x.size() != y.size()) throw data_error("a curve needs as many ordinates as abscissae");
  for (std::size_t k = 1; k < x.size(); ++k)
    if (!(x[k - 1] < x[k]))
      throw data_error("the abscissae of a curve must increase", {}, "sort the samples by abscissa");
  std::vector<Crossing> found;
  std::size_t last = x.size();
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (std::isnan(y[k])) continue;
    if (last < k && reaches(y[last], level) != reaches(y[k], level)) {
      const double way = std::clamp((level - y[last]) / (y[k] - y[last]), 0.0, 1.0);
      found.push_back({x[last] + way * (x[k] - x[last]), reaches(y[last], level) ? Direction::downward : Direction::upward});
    }
    last = k;
  }
  return found;
}

std::optional<double> last_upward_crossing(std::span<const double> x, std::span<const double> y, double level) {
  const std::vector<Crossing> all = crossings(x, y, level);
  for (auto c = all.rbegin(); c != all.rend(); ++c)
    if (c->direction == Direction::upward) return c->x;
  return std::nullopt;
}

Estimate crossing_of_mean(std::span<const double> x, std::span<const std::vector<double>> curves, double level) {
  return jackknife(curves.size(), [&](std::span<const std::size_t> which) {
    return last_upward_crossing(x, mean_curve(curves, which), level).value_or(std::numeric_limits<double>::quiet_NaN());
  });
}

}  // namespace jam
