#include "jamscape/stats/sign_test.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace jam {
namespace {

TEST(SignTest, DifferenceOverItsError) {
  const Moments a{20, 5, 0, 0.3}, b{20, 4, 0, 0.4};
  const Difference d = difference(a, b);
  EXPECT_DOUBLE_EQ(d.value, 1);
  EXPECT_DOUBLE_EQ(d.error, 0.5);
  EXPECT_DOUBLE_EQ(d.sigmas, 2);
}

TEST(SignTest, DecidesBeyondTwoErrors) {
  const Moments a{20, 5.1, 0, 0.3}, b{20, 4, 0, 0.4};
  EXPECT_EQ(sign_test(a, b), Sign::above);
  EXPECT_EQ(sign_test(b, a), Sign::below);
  EXPECT_EQ(sign_test(a, b, 3), Sign::undecided);
}

TEST(SignTest, SingleRunsDecideNothing) {
  const std::vector<double> one = {9}, two = {1, 2};
  EXPECT_EQ(sign_test(moments(one), moments(two)), Sign::undecided);
}

TEST(SignTest, WithoutSpread) {
  const Moments zero{20, 0, 0, 0}, one{20, 1, 0, 0};
  EXPECT_EQ(sign_test(one, zero), Sign::above);
  EXPECT_EQ(sign_test(zero, zero), Sign::undecided);
  EXPECT_EQ(difference(zero, zero).sigmas, 0);
}

}  // namespace
}  // namespace jam
