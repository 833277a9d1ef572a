#include "jamscape/base/mean.hpp"

#include <gtest/gtest.h>

namespace jam {
namespace {

TEST(Mean, OfEqualNumbersIsThatNumber) {
  for (const double x : {.1, .3, 1.0 / 3, 7e-9})
    for (const std::size_t n : {1u, 3u, 7u, 8u, 10u, 1000u, 100001u})
      EXPECT_EQ(mean_of(std::vector<double>(n, x)), x) << x << " " << n;
}

TEST(Mean, KeepsWhatEachAdditionLoses) {
  std::vector<double> values{1e16, -1e16};
  values.insert(values.end(), 30, 1.0);
  EXPECT_EQ(mean_of(values), 30.0 / 32);
}

TEST(Mean, NumbersInUnitsOfIt) {
  EXPECT_EQ(over_mean({1, 3}), (std::vector<double>{.5, 1.5}));
  EXPECT_EQ(over_mean(std::vector<double>(10, .1)), std::vector<double>(10, 1.0));
  EXPECT_EQ(over_mean({0, 0}), (std::vector<double>{0, 0}));
  EXPECT_EQ(mean_of({}), 0);
}

}  // namespace
}  // namespace jam
