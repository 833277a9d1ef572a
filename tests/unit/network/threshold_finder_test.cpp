#include "jamscape/network/threshold_finder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace jam {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Both levels at every threshold, next to it on both sides, and beyond the ends, against plain counting.
void expect_counts(const std::vector<double>& thresholds) {
  const ThresholdFinder finder(thresholds);
  std::vector<double> values = {-infinity, -1e300, 0, 1e300, infinity};
  for (const double t : thresholds)
    values.insert(values.end(), {t, std::nextafter(t, infinity), std::nextafter(t, -infinity)});
  for (const double v : values) {
    std::size_t reached = 0, exceeded = 0;
    for (const double t : thresholds) {
      reached += v >= t;
      exceeded += v > t;
    }
    EXPECT_EQ(finder.passed<Level::at_least>(v), reached) << v;
    EXPECT_EQ(finder.passed<Level::above>(v), exceeded) << v;
  }
}

TEST(ThresholdFinder, even_steps) {
  std::vector<double> grid;
  for (int k = 0; k <= 100; ++k) grid.push_back(.05 * k);
  expect_counts(grid);
}

TEST(ThresholdFinder, uneven_steps) { expect_counts({-3, -2.999, 0, 1e-12, 1, 1e6, 1e200}); }

TEST(ThresholdFinder, equal_thresholds) { expect_counts({0, 0, 1, 1, 1, 2, 2}); }

TEST(ThresholdFinder, no_range) {
  expect_counts({});
  expect_counts({1.5});
  expect_counts({1.5, 1.5});
}

TEST(ThresholdFinder, a_range_beyond_numbers) { expect_counts({-1.7e308, 0, 1.7e308}); }

}  // namespace
}  // namespace jam
