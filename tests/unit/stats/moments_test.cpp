#include "jamscape/stats/moments.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "jamscape/base/error.hpp"
#include "jamscape/stats/curves.hpp"

namespace jam {
namespace {

TEST(Moments, OfOneToFive) {
  const std::vector<double> x = {1, 2, 3, 4, 5};
  const Moments m = moments(x);
  EXPECT_EQ(m.n, 5u);
  EXPECT_DOUBLE_EQ(m.mean, 3);
  EXPECT_DOUBLE_EQ(m.sd, std::sqrt(2.5));
  EXPECT_DOUBLE_EQ(m.se, std::sqrt(0.5));
}

TEST(Moments, AreNotSpoiltByALargeOffset) {
  const std::vector<double> x = {1e9 + 1, 1e9 + 2, 1e9 + 3};
  EXPECT_DOUBLE_EQ(moments(x).sd, 1);
}

TEST(Moments, SayWhatIsUnknown) {
  EXPECT_TRUE(std::isnan(moments({}).mean));
  const std::vector<double> one = {7};
  EXPECT_EQ(moments(one).mean, 7);
  EXPECT_TRUE(std::isnan(moments(one).sd));
  EXPECT_TRUE(std::isnan(moments(one).se));
}

TEST(MeanCurve, PointByPointOfTheChosenCurves) {
  const std::vector<std::vector<double>> curves = {{1, 2}, {3, 6}, {100, 100}};
  const std::vector<std::size_t> which = {0, 1, 1};
  EXPECT_EQ(mean_curve(curves, which), (std::vector<double>{7.0 / 3, 14.0 / 3}));
  EXPECT_EQ(mean_curve(std::span(curves).first(2)), (std::vector<double>{2, 4}));
}

TEST(MeanCurve, RefusesCurvesThatDoNotMatch) {
  const std::vector<std::vector<double>> curves = {{1, 2}, {3}};
  EXPECT_THROW(mean_curve(curves), Error);
  EXPECT_THROW(mean_curve(std::vector<std::vector<double>>{}), Error);
  const std::vector<std::size_t> outside = {5};
  EXPECT_THROW(mean_curve(curves, outside), Error);
}

}  // namespace
}  // namespace jam
