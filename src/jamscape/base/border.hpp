// On which side of a border a number lies that has been rounded on its way: the one rule for bins, thresholds, margins
// and shells.
//
//   A number within 1e-12 of a border (times its size, or `scale`) is on it. Whether what is on the border belongs
//   above or below is said where the border is drawn: bins and shells hold their lower edge and not their upper one.
//
// 1e-12 is some thousand units in the last place: more than reading decimals, dividing by a mean and subtracting two
// numbers lose (.5 - .4 is .09999999999999998), less than any two measured numbers are told apart by. `scale` is the
// size of what was subtracted, where that is larger than the border.
//
// Many numbers at one border: compare them with on_from() or on_to(), computed once. No border is in reach of a NaN.
#pragma once

#include <algorithm>
#include <cmath>

namespace jam {

inline constexpr double border_margin = 1e-12;

/// The least number that is on the border, and the largest.
inline double on_from(double border, double scale = 0) {
  return border - border_margin * std::max(std::abs(border), scale);
}
inline double on_to(double border, double scale = 0) {
  return border + border_margin * std::max(std::abs(border), scale);
}

/// On the border or above it.
inline bool reaches(double value, double border, double scale = 0) { return value >= on_from(border, scale); }
/// Above the border and not on it.
inline bool exceeds(double value, double border, double scale = 0) { return value > on_to(border, scale); }

/// How many of the borders 1, 2, 3, ... a number reaches: the bin of a quotient value/width. Not below 0.
inline double borders_reached(double quotient) { return std::floor(std::max(quotient * (1 + border_margin), 0.0)); }

}  // namespace jam
