#include "jamscape/stats/curves.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include "jamscape/base/error.hpp"

namespace jam {

std::vector<double> mean_curve(std::span<const std::vector<double>> curves, std::span<const std::size_t> which) {
  if (which.empty()) throw data_error("the mean of no curves was asked for");
  std::vector<double> mean(curves[which[0] < curves.size() ? which[0] : 0].size(), 0.0);
  for (const std::size_t c : which) {
    if (c >= curves.size() || curves[c].size() != mean.size())
      throw data_error("curves of different lengths cannot be averaged");
    for (std::size_t k = 0; k < mean.size(); ++k) mean[k] += curves[c][k];
  }
  for (double& y : mean) y /= static_cast<double>(which.size());
  return mean;
}

std::vector<double> mean_curve(std::span<const std::vector<double>> curves) {
  std::vector<std::size_t> all(curves.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return mean_curve(curves, all);
}

std::vector<double> sum_of_curves(std::span<const std::vector<double>> curves, std::span<const std::size_t> which) {
  if (which.empty()) throw data_error("the sum of no curves was asked for");
  std::vector<double> sum(curves[which[0] < curves.size() ? which[0] : 0].size(), 0.0);
  for (const std::size_t c : which) {
    if (c >= curves.size() || curves[c].size() != sum.size())
      throw data_error("curves of different lengths cannot be added");
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += std::isfinite(curves[c][k]) ? curves[c][k] : 0.0;
  }
  return sum;
}

std::vector<double> ratio_of_sums(std::span<const std::vector<double>> over, std::span<const std::vector<double>> under,
                                  std::span<const std::size_t> which) {
  std::vector<double> ratio = sum_of_curves(over, which);
  const std::vector<double> norm = sum_of_curves(under, which);
  if (ratio.size() != norm.size()) throw data_error("curves of different lengths cannot be divided");
  for (std::size_t k = 0; k < ratio.size(); ++k)
    ratio[k] = norm[k] > 0 ? ratio[k] / norm[k] : std::numeric_limits<double>::quiet_NaN();
  return ratio;
}

}  // namespace jam
