#include "jamscape/stats/inflection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "jamscape/base/error.hpp"
#include "jamscape/stats/moments.hpp"

namespace jam {
namespace {

double jump(double x, double x0, double w) { return 0.3 + 2 * (x - 0.6) + 3 / (1 + std::exp(-(x - x0) / w)); }

std::vector<double> grid(int points) {
  std::vector<double> x;
  for (int k = 0; k < points; ++k) x.push_back(0.6 + 0.3 * k / (points - 1));
  return x;
}

TEST(Inflection, IsFoundWhereverItIs) {
  const std::vector<double> x = grid(100);
  for (const double x0 : {0.7013, 0.7884, 0.8615})
    for (const double w : {0.003, 0.01, 0.03}) {
      std::vector<double> y;
      for (const double t : x) y.push_back(jump(t, x0, w));
      const auto found = fit_inflection(x, y);
      ASSERT_TRUE(found) << x0 << " " << w;
      EXPECT_NEAR(found->x, x0, 1e-6);
      EXPECT_NEAR(found->width, w, 1e-5);
      EXPECT_NEAR(found->height, 3, 1e-3);
      EXPECT_NEAR(found->slope, 2, 1e-2);
      EXPECT_NEAR(found->offset, 0.3 - 1.2, 1e-2);
    }
}

TEST(Inflection, BootstrapErrorMatchesTheScatter) {
  const std::vector<double> x = grid(61);
  Random noise(3, "test", 0, "curves");
  std::vector<std::vector<double>> curves;
  std::vector<double> centres;
  for (int r = 0; r < 20; ++r) {
    const double x0 = 0.79 + 0.004 * std::sqrt(12.0) * (noise.uniform() - 0.5);
    centres.push_back(x0);
    std::vector<double> y;
    for (const double t : x) y.push_back(jump(t, x0, 0.01));
    curves.push_back(y);
  }
  Random random(3, "test", 0, "bootstrap");
  const Estimate e = inflection_of_mean(x, curves, 200, random);
  const Moments m = moments(centres);
  EXPECT_NEAR(e.value, m.mean, 3e-4);
  EXPECT_NEAR(e.error, m.se, 0.35 * m.se);
}

TEST(Inflection, OfAJumpBetweenTwoSamplesIsBetweenThem) {
  const std::vector<double> x = grid(31);  // spacing .01
  std::vector<double> y;
  for (const double t : x) y.push_back(t < 0.785 ? 0.2 : 3.2);
  const auto found = fit_inflection(x, y);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->x, 0.785, 0.003);
}

TEST(Inflection, OfAContactNumberIsAtItsJump) {
  // Z jumps to 3 over a width of about .002 and goes on like a square root.
  const std::vector<double> x = grid(100);
  std::vector<double> y;
  for (const double t : x) {
    const double above = std::max(0.0, t - 0.79);
    y.push_back(0.3 * t + (3 + 3.5 * std::sqrt(above)) / (1 + std::exp(-(t - 0.79) / 0.002)));
  }
  const auto found = fit_inflection(x, y);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->x, 0.79, 0.002);
  EXPECT_GT(found->height, 2);
}

TEST(Inflection, NoneIsAResult) {
  const std::vector<double> few = {1, 2, 3, 4, 5};
  EXPECT_FALSE(fit_inflection(few, few));
}

TEST(Inflection, RefusesUnsortedCurves) {
  const std::vector<double> x = {0, 2, 1}, y = {1, 2, 3};
  EXPECT_THROW(fit_inflection(x, y), Error);
}

}  // namespace
}  // namespace jam
