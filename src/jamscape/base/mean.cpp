#include "jamscape/base/mean.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace jam {
namespace {

constexpr std::size_t kSums = 8;

struct Sums {
  std::array<double, kSums> sum{}, lost{};

  void add(std::size_t k, double x) {
    const double s = sum[k] + x, part = s - sum[k];
    lost[k] += (sum[k] - (s - part)) + (x - part);
    sum[k] = s;
  }
};

double exact_mean(std::span<const double> values) {
  Sums sums;
  std::size_t n = 0;
  for (; n + kSums <= values.size(); n += kSums)
    for (std::size_t k = 0; k < kSums; ++k) sums.add(k, values[n + k]);
  for (; n < values.size(); ++n) sums.add(n % kSums, values[n]);
  Sums all;
  for (std::size_t k = 0; k < kSums; ++k) all.add(0, sums.sum[k]);
  for (std::size_t k = 0; k < kSums; ++k) all.lost[0] += sums.lost[k];
  const auto count = static_cast<double>(values.size());
  const double mean = all.sum[0] / count;
  return mean + (std::fma(-mean, count, all.sum[0]) + all.lost[0]) / count;
}

}  // namespace

double mean_of(std::span<const double> values) { return values.empty() ? 0 : exact_mean(values); }

void divide_by_mean(std::span<double> values, double mean) {
  if (!(mean > 0)) return;
  for (double& v : values) v /= mean;
}

std::vector<double> over_mean(std::vector<double> values) {
  divide_by_mean(values, mean_of(values));
  return values;
}

}  // namespace jam
