// Where a rising curve bends: the inflection of a logistic plus a line, fitted by least squares,
//
//   y = a + b x + c/(1 + exp(-(x - x0)/w)),
//
// whose second derivative changes sign at x0. Used for the jump of Z(phi) at jamming (S1 Table I, S2 Sec. 4; theory
// sec. 4). The line takes up the slopes on both sides of the jump; where these differ much (Z grows like a square root
// above jamming) x0 moves by a fraction of w, so narrow the range of x around the jump.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "jamscape/base/random.hpp"
#include "jamscape/stats/resampling.hpp"

namespace jam {

struct Inflection {
  double x = 0;         ///< x0
  double width = 0;     ///< w, at least a quarter of the smallest distance of two samples
  double height = 0;    ///< c
  double slope = 0;     ///< b
  double offset = 0;    ///< a
  double residual = 0;  ///< sum of the squared residuals
};

/// Empty when there are fewer than 6 points, the fit does not converge, or x0 falls outside the range of x.
/// x must increase strictly and have the length of y (else a data error).
std::optional<Inflection> fit_inflection(std::span<const double> x, std::span<const double> y);

/// The inflection of the mean of the curves, its error by bootstrap over the curves.
Estimate inflection_of_mean(std::span<const double> x, std::span<const std::vector<double>> curves,
                            std::size_t resamples, Random& random);

}  // namespace jam
