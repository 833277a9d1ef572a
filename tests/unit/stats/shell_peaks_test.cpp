#include "jamscape/stats/shell_peaks.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "jamscape/base/error.hpp"
#include "jamscape/stats/curves.hpp"
#include "jamscape/stats/moments.hpp"
#include "samples.hpp"

namespace jam {
namespace {

using namespace test;

struct Curve {
  std::vector<double> r, pairs, ideal;
};

/// pairs = ideal g with `ideal` growing like a shell in two dimensions; random counts where a stream is given.
Curve curve(const auto& g, double particles, Random* noise = nullptr) {
  Curve c;
  for (int k = 0; k < 200; ++k) {
    c.r.push_back(0.01 + 0.02 * k);
    c.ideal.push_back(particles * c.r.back() * 0.1);
    const double mean = c.ideal.back() * g(c.r.back());
    c.pairs.push_back(noise == nullptr ? mean : std::max(0.0, std::round(mean + std::sqrt(mean) * normal(*noise))));
  }
  return c;
}

double bump(double r, double at, double width) { return std::exp(-0.5 * (r - at) * (r - at) / (width * width)); }
double three(double r) {
  return (r > 0.5) + 3 * bump(r, 0.763, 0.05) + bump(r, 1.497, 0.08) + 0.5 * bump(r, 2.232, 0.1);
}

TEST(ShellPeaks, AreWhereTheyWerePut) {
  const Curve c = curve(three, 1e6);
  const auto peaks = shell_peaks(c.r, c.pairs, c.ideal);
  EXPECT_NEAR(peaks[0], 0.763, 0.004);
  EXPECT_NEAR(peaks[1], 1.497, 0.004);
  EXPECT_NEAR(peaks[2], 2.232, 0.004);
}

TEST(ShellPeaks, ALatticePutsThemInItsBins) {
  Curve c = curve([](double) { return 0.0; }, 1e4);
  for (const int bin : {50, 86, 100, 132, 150})
    c.pairs[static_cast<std::size_t>(bin)] = 600;  // 1, sqrt 3, 2, sqrt 7, 3
  const auto peaks = shell_peaks(c.r, c.pairs, c.ideal);
  EXPECT_NEAR(peaks[0], 1.01, 1e-9);
  EXPECT_NEAR(peaks[1], 1.73, 1e-9);
  EXPECT_NEAR(peaks[2], 2.65, 1e-9);
}

TEST(ShellPeaks, AreMissingInACurveThatRisesToOne) {
  Random noise(5, "shell peaks", 0, "counts");
  for (int run = 0; run < 20; ++run) {
    const Curve c = curve([](double r) { return 1 - std::exp(-2 * r * r); }, 5e3, &noise);
    for (const double p : shell_peaks(c.r, c.pairs, c.ideal)) EXPECT_TRUE(std::isnan(p)) << p;
  }
}

TEST(ShellPeaks, AWeakThirdIsMissingAndTheOthersStay) {
  const auto two = [](double r) { return three(r) - 0.47 * bump(r, 2.232, 0.1); };
  const Curve c = curve(two, 1e6);
  const auto peaks = shell_peaks(c.r, c.pairs, c.ideal);
  EXPECT_NEAR(peaks[1], 1.497, 0.004);
  EXPECT_TRUE(std::isnan(peaks[2]));
}

TEST(ShellPeaks, BootstrapErrorsAreTheScatterOfIndependentSums) {
  Random noise(6, "shell peaks", 0, "counts");
  const std::size_t parts = 30;
  std::vector<double> first;
  double claimed = 0;
  for (int run = 0; run < 20; ++run) {
    std::vector<std::vector<double>> pairs, ideal;
    for (std::size_t p = 0; p < parts; ++p) {
      const Curve c = curve(three, 200, &noise);
      pairs.push_back(c.pairs), ideal.push_back(c.ideal);
    }
    Random random(7, "shell peaks", static_cast<std::uint64_t>(run), "bootstrap");
    const auto peaks = shell_peaks(curve(three, 1).r, pairs, ideal, 100, random);
    EXPECT_EQ(peaks[0].n, parts);
    first.push_back(peaks[1].value);
    claimed += peaks[1].error / 20;
  }
  EXPECT_NEAR(moments(first).mean, 1.497, 0.02);
  EXPECT_NEAR(claimed, moments(first).sd, 0.5 * moments(first).sd);
}

TEST(ShellPeaks, OfNothing) {
  const Curve c = curve([](double) { return 0.0; }, 0);
  EXPECT_TRUE(std::isnan(shell_peaks(c.r, c.pairs, c.ideal)[0]));
  Random random(1, "shell peaks", 0, "bootstrap");
  EXPECT_TRUE(std::isnan(shell_peaks(c.r, {}, {}, 10, random)[0].value));
  EXPECT_THROW(shell_peaks(c.r, c.pairs, std::vector<double>{1}), Error);
}

TEST(Curves, RatioOfSumsPoolsRealisations) {
  const std::vector<std::vector<double>> over = {{1, 2, NAN}, {3, 0, 1}}, under = {{2, 0, 0}, {2, 0, 4}};
  const std::vector<std::size_t> both = {0, 1}, twice = {1, 1};
  EXPECT_EQ(ratio_of_sums(over, under, both)[0], 1);
  EXPECT_TRUE(std::isnan(ratio_of_sums(over, under, both)[1]));
  EXPECT_EQ(ratio_of_sums(over, under, both)[2], 0.25);
  EXPECT_EQ(ratio_of_sums(over, under, twice)[0], 1.5);
  EXPECT_EQ(sum_of_curves(over, twice), (std::vector<double>{6, 0, 2}));
  EXPECT_THROW(sum_of_curves(over, {}), Error);
}

}  // namespace
}  // namespace jam
