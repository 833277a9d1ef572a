#include "jamscape/stats/resampling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "jamscape/stats/moments.hpp"

namespace jam {
namespace {

const std::vector<double> sample = {1.0, 4.0, 2.0, 8.0, 5.0, 7.0};

double mean_of(std::span<const std::size_t> which) {
  double sum = 0;
  for (const std::size_t k : which) sum += sample[k];
  return sum / static_cast<double>(which.size());
}

TEST(Jackknife, OfTheMeanIsTheStandardError) {
  const Estimate e = jackknife(sample.size(), mean_of);
  EXPECT_DOUBLE_EQ(e.value, 4.5);
  EXPECT_NEAR(e.error, moments(sample).se, 1e-14);
  EXPECT_EQ(e.n, 6u);
}

TEST(Jackknife, IsUnknownWhereTheStatisticIs) {
  EXPECT_TRUE(std::isnan(jackknife(1, mean_of).error));
  EXPECT_EQ(jackknife(1, mean_of).value, 1);
  EXPECT_TRUE(std::isnan(jackknife(0, mean_of).value));
  const auto needs_all = [](std::span<const std::size_t> which) {
    return which.size() < sample.size() ? std::numeric_limits<double>::quiet_NaN() : 1.0;
  };
  EXPECT_EQ(jackknife(sample.size(), needs_all).value, 1);
  EXPECT_TRUE(std::isnan(jackknife(sample.size(), needs_all).error));
}

TEST(Bootstrap, OfTheMeanIsTheStandardErrorAtAnyNumber) {
  Random random(1, "test", 0, "bootstrap");
  const Estimate e = bootstrap(sample.size(), 20000, random, mean_of);
  EXPECT_DOUBLE_EQ(e.value, 4.5);
  EXPECT_NEAR(e.error, moments(sample).se, 0.02 * moments(sample).se);
  const double two = moments(std::span(sample).first(2)).se;
  EXPECT_NEAR(bootstrap(2, 20000, random, mean_of).error, two, 0.02 * two);
}

TEST(Bootstrap, RepeatsItself) {
  Random a(1, "test", 0, "bootstrap"), b(1, "test", 0, "bootstrap");
  EXPECT_EQ(bootstrap(sample.size(), 100, a, mean_of).error, bootstrap(sample.size(), 100, b, mean_of).error);
}

TEST(Bootstrap, IsUnknownWhenMostResamplesHaveNoValue) {
  Random random(1, "test", 0, "bootstrap");
  const auto first_only = [](std::span<const std::size_t> which) {
    return which[0] == 0 && which[1] == 1 ? 1.0 : std::numeric_limits<double>::quiet_NaN();
  };
  EXPECT_TRUE(std::isnan(bootstrap(sample.size(), 100, random, first_only).error));
}

}  // namespace
}  // namespace jam
