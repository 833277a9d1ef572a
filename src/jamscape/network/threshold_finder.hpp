// How many of many increasing thresholds a value passes. Evenly spaced thresholds, the usual case, cost a
// multiplication; others a binary search. Comparisons are exact: give bars() of the thresholds of a level.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "jamscape/network/level.hpp"

namespace jam {

class ThresholdFinder {
 public:
  /// The thresholds must not decrease and must outlive the finder.
  explicit ThresholdFinder(std::span<const double> thresholds) : thresholds_(thresholds) {
    if (thresholds_.size() < 2 || !(thresholds_.front() < thresholds_.back())) return;
    last_ = static_cast<double>(thresholds_.size() - 1);
    scale_ = last_ / (thresholds_.back() - thresholds_.front());
    if (!std::isfinite(scale_)) scale_ = 0;
  }

  /// The number of thresholds at which a value is kept; it is kept at the lowest ones. Not for NaN.
  template <Level level>
  std::size_t passed(double value) const {
    const auto keeps = [&](double threshold) {
      return level == Level::at_least ? value >= threshold : value > threshold;
    };
    if (scale_ > 0) {
      const double step = std::min(std::max((value - thresholds_.front()) * scale_, 0.0), last_);
      const auto near = static_cast<std::size_t>(static_cast<std::int64_t>(step));  // rounded to either side
      const std::size_t guess = near + keeps(thresholds_[near]);
      const bool below = guess == 0 || keeps(thresholds_[guess - 1]);
      const bool above = guess == thresholds_.size() || !keeps(thresholds_[guess]);
      if (below && above) return guess;
    }
    const auto end = std::partition_point(thresholds_.begin(), thresholds_.end(), keeps);
    return static_cast<std::size_t>(end - thresholds_.begin());
  }

 private:
  std::span<const double> thresholds_;
  double last_ = 0;   // index
  double scale_ = 0;  // thresholds over their range; 0 without a range
};

}  // namespace jam
