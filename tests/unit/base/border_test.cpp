#include "jamscape/base/border.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace jam {
namespace {

TEST(Border, DecimalsRoundedEitherWayAreOnIt) {
  for (const double tenth : {.5 - .4, 1.1 - 1.0, 1.0 - .9, .3 - .2, .1}) {
    EXPECT_TRUE(reaches(tenth, .1, 1));
    EXPECT_FALSE(exceeds(tenth, .1, 1));
  }
  EXPECT_FALSE(reaches(.1 - 1e-11, .1, 1));
  EXPECT_TRUE(exceeds(.1 + 1e-11, .1, 1));
}

TEST(Border, TheScaleIsThatOfWhatWasSubtracted) {
  const double life = 100000.1 - 100000.0;  // .10000000000582077
  EXPECT_TRUE(exceeds(life, .1));
  EXPECT_FALSE(exceeds(life, .1, 100000));
}

TEST(Border, ZeroHasNoMarginWithoutAScale) {
  EXPECT_TRUE(exceeds(1e-300, 0));
  EXPECT_FALSE(reaches(-1e-300, 0));
  EXPECT_FALSE(exceeds(1e-15, 0, 1));
}

TEST(Border, NothingReachesANan) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(reaches(nan, 1));
  EXPECT_FALSE(exceeds(nan, 1));
  EXPECT_TRUE(exceeds(inf, 1));
}

TEST(Border, QuotientsFallInTheBinTheyBegin) {
  for (int k = 1; k < 1000; ++k) EXPECT_EQ(borders_reached(.02 * k / .02), k) << k;
  EXPECT_EQ(borders_reached(.3 / .1), 3);  // 2.9999999999999996
  EXPECT_EQ(borders_reached(2.99999), 2);
  EXPECT_EQ(borders_reached(-1), 0);
}

}  // namespace
}  // namespace jam
