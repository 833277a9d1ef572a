// Errors of any statistic of an ensemble, by leaving realisations out or drawing them again.
//
//   jackknife:  se^2 = (n - 1)/n sum_i (s_i - mean(s))^2,   s_i the statistic without realisation i
//   bootstrap:  se = sqrt(n/(n - 1)) times the standard deviation of the statistic over resamples of n realisations
//               drawn with replacement; without the factor it is too small, at n = 2 by the square root of two
//
// Both give sd/sqrt(n) for a mean. As there, se rests on n values: the interval of 68 % is t_n se on either side, with
// Student's t_n = 1.84, 1.14, 1.03 at n = 2, 5, 20.
//
// Source: Efron, The jackknife, the bootstrap and other resampling plans (SIAM 1982).
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "jamscape/base/random.hpp"

namespace jam {

/// The statistic over all realisations and its standard error, from n realisations.
/// `value` is NaN where the statistic is (no crossing, say); `error` where it cannot be estimated.
struct Estimate {
  double value = 0;
  double error = 0;
  std::size_t n = 0;
};

/// A statistic of the realisations with these indices; NaN where it has no value.
using Statistic = std::function<double(std::span<const std::size_t> realisations)>;

/// The error is NaN for n < 2, and when the statistic has no value without one of the realisations.
Estimate jackknife(std::size_t n, const Statistic& statistic);

/// The error from values of a statistic over resamples of n realisations, n > 1.
double bootstrap_error(std::size_t n, std::span<const double> resampled);

/// Resamples without a value are left out; the error is NaN when fewer than half of them have one, or n < 2.
Estimate bootstrap(std::size_t n, std::size_t resamples, Random& random, const Statistic& statistic);

}  // namespace jam
