#include "jamscape/study/averaging.hpp"

#include <cmath>

#include "jamscape/stats/none.hpp"
#include "jamscape/stats/resampling.hpp"

namespace jam {
namespace {

}  // namespace

Moments average(std::vector<double> values, Averaging averaging) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  if (averaging == Averaging::mean) return moments(values);
  const std::size_t all = values.size();
  std::erase(values, 0.0);
  if (averaging == Averaging::nonzero_or_missing) return 2 * values.size() < all ? moments({}) : moments(values);
  return 2 * (all - values.size()) >= all && all > 0 ? Moments{all, 0, none, none} : moments(values);
}

Moments pooled_ratio(const std::vector<double>& over, const std::vector<double>& under) {
  std::vector<std::size_t> known;
  for (std::size_t r = 0; r < over.size(); ++r)
    if (std::isfinite(over[r]) && std::isfinite(under[r])) known.push_back(r);
  const Estimate e = jackknife(known.size(), [&](std::span<const std::size_t> which) {
    double a = 0, b = 0;
    for (const std::size_t k : which) a += over[known[k]], b += under[known[k]];
    return b == 0 ? none : a / b;
  });
  return {e.n, e.value, e.error * std::sqrt(static_cast<double>(e.n)), e.error};
}

}  // namespace jam
