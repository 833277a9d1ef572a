// Mean, spread and error of a sample.
//
//   mean = sum(x)/n,   sd^2 = sum (x - mean)^2/(n - 1),   se = sd/sqrt(n)
#pragma once

#include <cstddef>
#include <span>

namespace jam {

/// `sd` and `se` are NaN for n < 2, `mean` for n = 0.
struct Moments {
  std::size_t n = 0;
  double mean = 0;
  double sd = 0;  ///< standard deviation of one value (n - 1 in the denominator)
  double se = 0;  ///< standard error of the mean
};

/// Sums run in the order given: equal input gives equal bits.
Moments moments(std::span<const double> values);

}  // namespace jam
