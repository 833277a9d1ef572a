#include "jamscape/base/mean.hpp"

#include <cmath>
#include <cstddef>

namespace jam {
namespace {

constexpr std::size_t kSums = 8;

/// The sum of x is sum + lost.
struct Sum {
  double sum = 0, lost = 0;

  void add(double x) {
    const double s = sum + x, part = s - sum;
    lost += (sum - (s - part)) + (x - part);
    sum = s;
  }
};

/// Eight sums side by side, arrays of their own so that they fill vector registers.
Sum exact_sum(std::span<const double> values) {
  double sum[kSums] = {}, lost[kSums] = {};
  std::size_t n = 0;
  for (; n + kSums <= values.size(); n += kSums) {
    double s[kSums], part[kSums];
    for (std::size_t k = 0; k < kSums; ++k) s[k] = sum[k] + values[n + k];
    for (std::size_t k = 0; k < kSums; ++k) part[k] = s[k] - sum[k];
    for (std::size_t k = 0; k < kSums; ++k) lost[k] += (sum[k] - (s[k] - part[k])) + (values[n + k] - part[k]);
    for (std::size_t k = 0; k < kSums; ++k) sum[k] = s[k];
  }
  Sum all;
  for (; n < values.size(); ++n) all.add(values[n]);
  for (std::size_t k = 0; k < kSums; ++k) all.add(sum[k]);
  for (std::size_t k = 0; k < kSums; ++k) all.lost += lost[k];
  return all;
}

}  // namespace

double mean_of(std::span<const double> values) {
  if (values.empty()) return 0;
  const Sum all = exact_sum(values);
  const auto count = static_cast<double>(values.size());
  const double mean = all.sum / count;
  return mean + (std::fma(-mean, count, all.sum) + all.lost) / count;
}

void divide_by_mean(std::span<double> values, double mean) {
  for (double& v : values) v = over_mean(v, mean);
}

std::vector<double> over_mean(std::vector<double> values) {
  divide_by_mean(values, mean_of(values));
  return values;
}

}  // namespace jam
