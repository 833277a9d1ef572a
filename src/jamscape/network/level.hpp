// Which edges a threshold keeps. A weight on the threshold to within round-off is on it (base/border.hpp), and kept by
// `at_least` only.
#pragma once

#include <span>
#include <vector>

#include "jamscape/base/border.hpp"

namespace jam {

enum class Level {
  at_least,  ///< weight >= threshold (S1)
  above,     ///< weight > threshold (S2)
};

/// The number to compare weights with, by >= or >, in place of the threshold.
inline double bar(Level level, double threshold) {
  return level == Level::at_least ? on_from(threshold) : on_to(threshold);
}

/// Of each threshold.
inline std::vector<double> bars(Level level, std::span<const double> thresholds) {
  std::vector<double> out;
  out.reserve(thresholds.size());
  for (const double t : thresholds) out.push_back(bar(level, t));
  return out;
}

/// Whether a threshold keeps this weight.
inline bool keeps(Level level, double weight, double threshold) {
  return level == Level::at_least ? weight >= bar(level, threshold) : weight > bar(level, threshold);
}

}  // namespace jam
