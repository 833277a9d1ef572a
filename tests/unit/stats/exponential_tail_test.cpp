#include "jamscape/stats/exponential_tail.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "jamscape/base/error.hpp"
#include "jamscape/stats/moments.hpp"
#include "samples.hpp"

namespace jam {
namespace {

using namespace test;

TEST(TailExponent, OfAnExponentialIsItsRateByAllEstimators) {
  std::vector<double> centre, count;
  const std::vector<double> norm(50, 1e4);
  for (int k = 0; k < 50; ++k) {
    centre.push_back(0.1 + 0.2 * k);
    count.push_back(1e4 * 0.8 * std::exp(-1.4 * centre.back()));
  }
  for (double& p : std::span(count).first(5)) p = 7e4;  // what lies below 1 plays no part
  EXPECT_NEAR(tail_exponent(centre, count, norm).value, 1.4, 1e-9);
  EXPECT_EQ(tail_exponent(centre, count, norm).n, 45u);
  EXPECT_NEAR(tail_exponent_loglinear(centre, count, norm).value, 1.4, 1e-12);
  Random random(2, "tail", 0, "sample");
  std::vector<double> sample(40000);
  for (double& f : sample) f = exponential(random, 1.4);
  const Estimate k = tail_exponent_likelihood(sample);
  EXPECT_NEAR(static_cast<double>(k.n), 40000 * std::exp(-1.4), 300);
  EXPECT_NEAR(k.value, 1.4, 3 * k.error);
  EXPECT_NEAR(k.error, 1.4 / std::sqrt(static_cast<double>(k.n)), 0.05 * k.error);
}

// theory sec. 4: 10^4 values of Mueth's law; the scatter of a single sample is given there beside each.
TEST(TailExponent, OnMuethsLawTheEstimatorsDifferAsTheoryHasIt) {
  std::vector<double> nls, log, mle, nls_error, log_error, mle_error;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const std::vector<double> sample = mueth_sample(10000, seed);
    const Counts c = counts(sample);
    const Estimate k = tail_exponent(c.centre, c.count, c.norm), l = tail_exponent_loglinear(c.centre, c.count, c.norm),
                   m = tail_exponent_likelihood(sample);
    nls.push_back(k.value), nls_error.push_back(k.error);
    log.push_back(l.value), log_error.push_back(l.error);
    mle.push_back(m.value), mle_error.push_back(m.error);
  }
  EXPECT_NEAR(moments(nls).mean, 1.248, 0.012);
  EXPECT_NEAR(moments(nls).sd, 0.025, 0.008);
  EXPECT_NEAR(moments(log).mean, 1.31, 0.05);
  EXPECT_NEAR(moments(mle).mean, 1.356, 0.008);
  EXPECT_NEAR(moments(mle).sd, 0.017, 0.008);
}

// 40,000 contacts: resampling them gives .013 (.015 at the packing this was found in), the residuals of the fit .06.
TEST(TailExponent, ItsErrorIsOfTheCountsAndNotOfTheMisfit) {
  const std::vector<double> sample = mueth_sample(40000, 3);
  const Counts c = counts(sample);
  Random random(3, "tail", 0, "bootstrap");
  std::vector<double> again;
  for (int r = 0; r < 100; ++r) {
    Histogram h(Spacing::linear, 0, 10, 50);
    for (std::size_t k = 0; k < sample.size(); ++k) h.add(sample[random.below(sample.size())]);
    const std::vector<double> count(h.counts().begin(), h.counts().end());
    again.push_back(tail_exponent(c.centre, count, c.norm).value);
  }
  EXPECT_NEAR(tail_exponent(c.centre, c.count, c.norm).error / moments(again).sd, 1, 0.25);
}

TEST(TailExponent, ForcesThatAreEqualButForRoundingHaveNoneAboveTheirMean) {
  for (const double ulps : {1.0, 2.0, 50.0}) {
    const std::vector<double> sample(10, 1 + ulps * 0x1p-52);
    const Estimate k = tail_exponent_likelihood(sample);
    EXPECT_EQ(k.n, 0u) << ulps;
    EXPECT_TRUE(std::isnan(k.value) && std::isnan(k.error));
  }
  // A bin whose centre is 1 belongs to no tail, whichever way .8 + .2 is rounded.
  const std::vector<double> count = {5, 4, 3, 2, 1}, norm(5, 10.0);
  const double centres[2][5] = {{1 - 0x1p-52, 1.4, 1.8, 2.2, 2.6}, {1 + 0x1p-52, 1.4, 1.8, 2.2, 2.6}};
  for (const auto& centre : centres) EXPECT_EQ(tail_exponent(centre, count, norm).n, 4u);
}

TEST(TailExponent, IsMissingWithoutATail) {
  const std::vector<double> centre = {0.5, 1.5, 2.5, 3.5}, none(4, 0.0), norm(4, 1.0);
  EXPECT_TRUE(std::isnan(tail_exponent(centre, none, norm).value));
  EXPECT_TRUE(std::isnan(tail_exponent(centre, std::vector<double>{1, 1, 0, 0}, norm).value)) << "any k fits one bin";
  EXPECT_TRUE(std::isnan(
      tail_exponent(std::span(centre).first(3), std::vector<double>{1, 1, 1}, std::span(norm).first(3)).value));
  EXPECT_TRUE(std::isnan(tail_exponent_loglinear(centre, std::vector<double>{1, 0.5, 0, 0.2}, norm).value));
  EXPECT_TRUE(std::isnan(tail_exponent_likelihood(std::vector<double>{0.2, 1.0}).value));
  EXPECT_TRUE(std::isnan(tail_exponent_likelihood(1, 0.5).error));
  EXPECT_THROW(tail_exponent(centre, std::vector<double>{1, 2}, norm), Error);
}

}  // namespace
}  // namespace jam
