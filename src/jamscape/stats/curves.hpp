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

}  // namespace jam
