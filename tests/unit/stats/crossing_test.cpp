#include "jamscape/stats/crossing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "jamscape/base/error.hpp"
#include "jamscape/stats/moments.hpp"

namespace jam {
namespace {

TEST(Crossing, InterpolatesLinearly) {
  const std::vector<double> x = {0.78, 0.80}, y = {2, 4};
  ASSERT_TRUE(last_upward_crossing(x, y, 3));
  EXPECT_NEAR(*last_upward_crossing(x, y, 3), 0.79, 1e-15);
}

TEST(Crossing, TakesTheLastUpwardOne) {
  const std::vector<double> x = {0, 1, 2, 3, 4, 5}, y = {2, 4, 2, 4, 3.5, 2.5};
  const std::vector<Crossing> all = crossings(x, y, 3);
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[0].direction, Direction::upward);
  EXPECT_EQ(all[1].direction, Direction::downward);
  EXPECT_DOUBLE_EQ(all[1].x, 1.5);
  EXPECT_EQ(all[3].direction, Direction::downward);
  EXPECT_DOUBLE_EQ(*last_upward_crossing(x, y, 3), 2.5);
}

TEST(Crossing, ASampleOnTheLevelIsReached) {
  const std::vector<double> x = {0, 1, 2}, y = {2, 3, 4};
  const std::vector<Crossing> all = crossings(x, y, 3);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_DOUBLE_EQ(all[0].x, 1);
  const std::vector<double> touch = {2, 3, 2};
  EXPECT_EQ(crossings(x, touch, 3).size(), 2u);
}

TEST(Crossing, ASampleOnTheLevelButForRoundingIsOnIt) {
  const std::vector<double> x = {0, 1}, just = {2, std::nextafter(3.0, 2.0)}, over = {2, std::nextafter(3.0, 4.0)};
  ASSERT_TRUE(last_upward_crossing(x, just, 3));
  EXPECT_EQ(*last_upward_crossing(x, just, 3), 1);
  EXPECT_NEAR(*last_upward_crossing(x, over, 3), 1, 1e-15);
}

TEST(Crossing, NoneIsAResult) {
  const std::vector<double> x = {0, 1}, above = {4, 5}, falling = {5, 1};
  EXPECT_FALSE(last_upward_crossing(x, above, 3));
  EXPECT_FALSE(last_upward_crossing(x, falling, 3));
  EXPECT_FALSE(last_upward_crossing({}, {}, 3));
}

TEST(Crossing, SkipsMissingSamples) {
  const std::vector<double> x = {0, 1, 2}, y = {2, std::numeric_limits<double>::quiet_NaN(), 4};
  EXPECT_DOUBLE_EQ(*last_upward_crossing(x, y, 3), 1);
}

TEST(Crossing, OfTheMeanOfShiftedLinesIsTheMeanShift) {
  // y = x - s: the mean crosses 3 at 3 + mean(s), and leaving one out shifts it like the mean itself.
  const std::vector<double> x = {0, 2, 4, 6, 8}, shifts = {0.0, 0.3, 0.9, 0.4};
  std::vector<std::vector<double>> curves;
  for (const double s : shifts) {
    std::vector<double> y;
    for (const double t : x) y.push_back(t - s);
    curves.push_back(y);
  }
  const Estimate e = crossing_of_mean(x, curves, 3);
  EXPECT_NEAR(e.value, 3.4, 1e-12);
  EXPECT_NEAR(e.error, moments(shifts).se, 1e-12);
  EXPECT_EQ(e.n, 4u);
  EXPECT_TRUE(std::isnan(crossing_of_mean(x, curves, 30).value));
  EXPECT_TRUE(std::isnan(crossing_of_mean({}, {}, 3).value));
}

TEST(Crossing, RefusesUnsortedCurves) {
  const std::vector<double> x = {0, 2, 1}, y = {1, 2, 3}, shorter = {1};
  EXPECT_THROW(crossings(x, y, 2), Error);
  EXPECT_THROW(crossings(x, shorter, 2), Error);
}

}  // namespace
}  // namespace jam
