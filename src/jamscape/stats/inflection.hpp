// Where a rising curve bends: the inflection of a logistic plus a line, fitted by least squares,
//
//   y = a + b x + (c + d (x - x0))/(1 + exp(-(x - x0)/w)),
//
// whose second derivative changes sign at x0 (to within 4 d w^2/c). Used for the jump of Z(phi) at jamming (S1 Table I,
// S2 Sec. 4; theory sec. 4). With equal slopes on both sides (d = 0) a curve that is flat below the jump and goes on
// like a square root above it, as Z does, moves x0 up by some thousandths: narrow the range of x around the jump, or
// allow different slopes, which takes the whole curve.
//
// Samples a distance h apart tell little about where between two of them a narrow jump is, and resampling cannot see
// that: curves that all jump in the same gap agree. So the error h/sqrt(12) of a place anywhere in the gap is added in
// quadrature, in full for w = h/4 and less, falling linearly to nothing at w = h/2.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "jamscape/base/random.hpp"
#include "jamscape/stats/resampling.hpp"

namespace jam {

/// Of the line below and above the jump.
enum class Slopes {
  equal,      ///< d = 0; needs 6 points
  different,  ///< needs 7 points
};

struct Inflection {
  double x = 0;           ///< x0
  double width = 0;       ///< w, at least a quarter of the smallest distance of two samples
  double height = 0;      ///< c
  double slope = 0;       ///< b, the slope below the jump
  double gain = 0;        ///< d, by how much the slope above is larger
  double offset = 0;      ///< a
  double y = 0;           ///< the fitted curve at x0: half way up the jump
  double resolution = 0;  ///< h/sqrt(12) as far as the jump is too narrow for the samples, else 0
  double residual = 0;    ///< sum of the squared residuals
};

/// Empty when there are too few points, the fit does not converge, or x0 falls outside the range of x.
/// x must increase strictly and have the length of y (else a data error).
std::optional<Inflection> fit_inflection(std::span<const double> x, std::span<const double> y,
                                         Slopes slopes = Slopes::equal);

/// The inflection of the mean of the curves; its error by bootstrap over the curves and, in quadrature, the resolution
/// of the samples. One curve has no error.
Estimate inflection_of_mean(std::span<const double> x, std::span<const std::vector<double>> curves,
                            std::size_t resamples, Random& random, Slopes slopes = Slopes::equal);

}  // namespace jam
