#include "jamscape/study/averaging.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace jam {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

TEST(Averages, MissingValuesNeverCount) {
  const Moments m = average({1, none, 3}, Averaging::mean);
  EXPECT_EQ(m.n, 2u);
  EXPECT_EQ(m.mean, 2);
  EXPECT_EQ(average({none}, Averaging::mean).n, 0u);
}

TEST(Averages, OfThePercolatingClusterNeedHalfOfTheRealisations) {
  EXPECT_EQ(average({0, 0, 0.6, 0.8}, Averaging::nonzero_or_missing).mean, 0.7) << "half is enough";
  const Moments m = average({0, 0, 0.6}, Averaging::nonzero_or_missing);
  EXPECT_EQ(m.n, 0u);
  EXPECT_TRUE(std::isnan(m.mean));
  EXPECT_EQ(average({0.5, none, 0}, Averaging::nonzero_or_missing).mean, 0.5) << "one of two known";
}

TEST(Averages, OfTheShapeAreZeroWhenHalfAreZero) {
  const Moments half = average({0, 0, 0.6, 0.8}, Averaging::nonzero_or_zero);
  EXPECT_EQ(half.mean, 0);
  EXPECT_EQ(half.n, 4u);
  const Moments most = average({0, 0.6, 0.8}, Averaging::nonzero_or_zero);
  EXPECT_EQ(most.mean, 0.7);
  EXPECT_EQ(most.n, 2u);
  EXPECT_EQ(average({none}, Averaging::nonzero_or_zero).n, 0u);
}

// <S> of clusters 1 x 10 grains and 3 x 2 grains is 16/4, not the mean of 10 and 2.
TEST(PooledRatios, AreRatiosOfSums) {
  const Moments m = pooled_ratio({10, 6}, {1, 3});
  EXPECT_EQ(m.mean, 4);
  EXPECT_EQ(m.n, 2u);
  EXPECT_NEAR(m.se, 4, 1e-12) << "jackknife of 10 and 2: sqrt(1/2 (16 + 16))";
  EXPECT_NEAR(m.sd, 4 * std::sqrt(2.0), 1e-12);
  EXPECT_TRUE(std::isnan(pooled_ratio({0, 0}, {0, 0}).mean));
  EXPECT_EQ(pooled_ratio({4, none}, {2, 1}).mean, 2);
}

}  // namespace
}  // namespace jam
