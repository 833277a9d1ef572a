// Where a sampled curve crosses a level, by linear interpolation between samples:
//
//   x = x_k + (level - y_k)/(y_{k+1} - y_k) (x_{k+1} - x_k)
//
// A curve crosses upward where a sample below the level is followed by one at or above it, downward where one at or
// above is followed by one below; a sample on the level but for rounding is on it (base/border.hpp). The Z(phi) of a packing may cross 3 several times in the dilute state; jamming is its
// last upward crossing (S1 Table I; theory sec. 4).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "jamscape/stats/resampling.hpp"

namespace jam {

enum class Direction { upward, downward };

struct Crossing {
  double x = 0;
  Direction direction = Direction::upward;
};

/// All crossings, in order. x must increase strictly, y has its length (else a data error). Samples with NaN are
/// skipped.
std::vector<Crossing> crossings(std::span<const double> x, std::span<const double> y, double level);

std::optional<double> last_upward_crossing(std::span<const double> x, std::span<const double> y, double level);

/// The last upward crossing of the mean of the curves, its error by jackknife over the curves; NaN without a crossing.
Estimate crossing_of_mean(std::span<const double> x, std::span<const std::vector<double>> curves, double level);

}  // namespace jam
