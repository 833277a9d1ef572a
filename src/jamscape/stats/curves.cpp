#include "jamscape/stats/curves.hpp"

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

}  // namespace jam
