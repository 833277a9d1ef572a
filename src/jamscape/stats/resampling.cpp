#include "jamscape/stats/resampling.hpp"

#include <cmath>
#include <numeric>
#include <vector>

#include "jamscape/stats/moments.hpp"
#include "jamscape/stats/none.hpp"

namespace jam {
namespace {

Estimate over_all(std::size_t n, const Statistic& statistic) {
  std::vector<std::size_t> all(n);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return {n == 0 ? none : statistic(all), none, n};
}

}  // namespace

Estimate jackknife(std::size_t n, const Statistic& statistic) {
  Estimate e = over_all(n, statistic);
  if (n < 2) return e;
  std::vector<double> values;
  std::vector<std::size_t> kept(n - 1);
  for (std::size_t out = 0; out < n; ++out) {
    for (std::size_t k = 0; k + 1 < n; ++k) kept[k] = k + (k >= out);
    values.push_back(statistic(kept));
  }
  e.error = moments(values).sd * (static_cast<double>(n) - 1) / std::sqrt(static_cast<double>(n));
  return e;
}

double bootstrap_error(std::size_t n, std::span<const double> resampled) {
  return moments(resampled).sd * std::sqrt(static_cast<double>(n) / (static_cast<double>(n) - 1));
}

Estimate bootstrap(std::size_t n, std::size_t resamples, Random& random, const Statistic& statistic) {
  Estimate e = over_all(n, statistic);
  if (n < 2) return e;
  std::vector<double> values;
  std::vector<std::size_t> drawn(n);
  for (std::size_t r = 0; r < resamples; ++r) {
    for (std::size_t& k : drawn) k = static_cast<std::size_t>(random.below(n));
    const double value = statistic(drawn);
    if (!std::isnan(value)) values.push_back(value);
  }
  if (2 * values.size() >= resamples) e.error = bootstrap_error(n, values);
  return e;
}

}  // namespace jam
