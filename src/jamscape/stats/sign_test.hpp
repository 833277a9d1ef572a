// Is one ensemble mean above another? The difference of two means over its standard error,
//
//   t = (mean_a - mean_b)/sqrt(se_a^2 + se_b^2),
//
// decided where |t| exceeds a number of standard errors (2 in theory sec. 6a).
#pragma once

#include "jamscape/stats/moments.hpp"

namespace jam {

struct Difference {
  double value = 0;   ///< mean_a - mean_b
  double error = 0;   ///< NaN when either ensemble has fewer than two members
  double sigmas = 0;  ///< value/error; infinite when both ensembles have no spread but differ, 0 when they are equal
};

Difference difference(const Moments& a, const Moments& b);

enum class Sign { above, below, undecided };

/// Is a above b by more than `sigmas` standard errors? Undecided where the error is unknown.
Sign sign_test(const Moments& a, const Moments& b, double sigmas = 2);

}  // namespace jam
