// Several curves sampled at the same abscissae.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace jam {

/// Point-wise mean of the curves named by `which` (an index may occur repeatedly, as a bootstrap wants).
/// Throws a data error if `which` is empty, out of range, or the curves differ in length.
std::vector<double> mean_curve(std::span<const std::vector<double>> curves, std::span<const std::size_t> which);

/// Of all curves.
std::vector<double> mean_curve(std::span<const std::vector<double>> curves);

/// Sum of `over` divided by sum of `under`, bin by bin, over the realisations named by `which`: pooled histograms
/// (counts and norms) and pair counts (pairs and those of an ideal gas). NaN in a bin whose sum of `under` is not above
/// 0. Values that are not finite count as 0. Errors as above.
std::vector<double> ratio_of_sums(std::span<const std::vector<double>> over, std::span<const std::vector<double>> under,
                                  std::span<const std::size_t> which);

/// Sum of the curves named by `which`, bin by bin; values that are not finite count as 0. Errors as above.
std::vector<double> sum_of_curves(std::span<const std::vector<double>> curves, std::span<const std::size_t> which);

}  // namespace jam
