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

TEST(Inflection, WithDifferentSlopesIsExact) {
  const std::vector<double> x = grid(60);
  std::vector<double> y;
  for (const double t : x)
    y.push_back(0.1 + 0.5 * (t - 0.6) + (3 + 12 * (t - 0.77)) / (1 + std::exp(-(t - 0.77) / 0.008)));
  const auto found = fit_inflection(x, y, Slopes::different);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->x, 0.77, 1e-6);
  EXPECT_NEAR(found->width, 0.008, 1e-5);
  EXPECT_NEAR(found->height, 3, 1e-3);
  EXPECT_NEAR(found->slope, 0.5, 1e-2);
  EXPECT_NEAR(found->gain, 12, 1e-2);
  EXPECT_NEAR(found->y, 0.1 + 0.5 * 0.17 + 1.5, 1e-4);
  EXPECT_EQ(found->resolution, 0);
}

TEST(Inflection, ErrorKnowsHowFarSamplesAreApart) {
  // Every curve jumps in the same gap, so that all resamples agree.
  const std::vector<double> x = grid(31);
  std::vector<double> y;
  for (const double t : x) y.push_back(t < 0.785 ? 0.2 : 3.2);
  Random random(3, "test", 0, "bootstrap");
  const Estimate e = inflection_of_mean(x, std::vector<std::vector<double>>(4, y), 50, random);
  EXPECT_NEAR(e.error, 0.01 / std::sqrt(12.0), 1e-6);
  const Estimate one = inflection_of_mean(x, std::vector<std::vector<double>>(1, y), 50, random);
  EXPECT_NEAR(one.value, 0.785, 0.003);
  EXPECT_TRUE(std::isnan(one.error));
}

/// Contact numbers of a packing compressed in steps: next to nothing, a jump, and a square root (S2).
struct Jamming {
  double lowest, highest, at, scatter;  // packing fractions
  double below, jump, rise;             // contact numbers
  double step;
  std::size_t runs;
};

class InflectionOfContactNumbers : public testing::TestWithParam<Jamming> {};

TEST_P(InflectionOfContactNumbers, IsWhereTheyJamOnAverage) {
  const Jamming& j = GetParam();
  double bias = 0, squares = 0;
  constexpr int phases = 6;  // where the jump lies between two samples
  for (int phase = 0; phase < phases; ++phase) {
    const auto run = static_cast<std::uint64_t>(phase);
    Random noise(7, "jamming", run, "curves"), random(7, "jamming", run, "bootstrap");
    const auto about = [&](double centre, double sd) {
      return centre + sd * std::sqrt(12.0) * (noise.uniform() - 0.5);
    };
    std::vector<double> x;  // a grid aligned on the highest packing fraction
    for (double t = j.highest; t > j.lowest; t -= j.step) x.insert(x.begin(), t);
    std::vector<std::vector<double>> curves;
    double mean = 0;
    for (std::size_t r = 0; r < j.runs; ++r) {
      const double at = about(j.at + j.step * (phase + 0.5) / phases, j.scatter);
      mean += at / static_cast<double>(j.runs);
      std::vector<double> y;
      for (const double t : x)
        y.push_back(about(t < at ? j.below * std::exp((t - at) / 0.05) : j.jump + j.rise * std::sqrt(t - at), 0.03));
      curves.push_back(y);
    }
    const Estimate e = inflection_of_mean(x, curves, 25, random, Slopes::different);
    ASSERT_LT(std::abs(e.value - mean), j.step / 2 + 1e-3) << phase;
    bias += (e.value - mean) / phases;
    squares += (e.value - mean) * (e.value - mean) / (e.error * e.error) / phases;
  }
  EXPECT_LT(std::abs(bias), 0.15 * j.step);
  EXPECT_LT(squares, 1.5);   // the quoted error covers the deviations
  EXPECT_GT(squares, 0.02);  // and is not much too large
}

INSTANTIATE_TEST_SUITE_P(Systems, InflectionOfContactNumbers,
                         testing::Values(Jamming{.63, .906, .832, .003, .3, 2.6, 4, .02, 3},
                                         Jamming{.63, .906, .832, .003, .3, 2.6, 4, .02, 20},
                                         Jamming{.63, .906, .84, .003, .3, 2.6, 4, .005, 3},
                                         Jamming{.63, .89, .83, .002, .6, 2.9, 3, .005, 20},
                                         Jamming{.28, .71, .56, .004, .3, 4, 5.5, .02, 3},
                                         Jamming{.28, .71, .57, .004, .3, 4, 5.5, .005, 3},
                                         Jamming{.28, .71, .57, .004, .3, 4, 5.5, .005, 20}));

TEST(Inflection, NoneIsAResult) {
  const std::vector<double> few = {1, 2, 3, 4, 5}, more = {1, 2, 3, 4, 5, 6};
  EXPECT_FALSE(fit_inflection(few, few));
  EXPECT_FALSE(fit_inflection(more, more, Slopes::different));
}

TEST(Inflection, RefusesUnsortedCurves) {
  const std::vector<double> x = {0, 2, 1}, y = {1, 2, 3};
  EXPECT_THROW(fit_inflection(x, y), Error);
}

}  // namespace
}  // namespace jam
