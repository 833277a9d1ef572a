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
  std::vector<double> centre, density;
  for (int k = 0; k < 50; ++k) {
    centre.push_back(0.1 + 0.2 * k);
    density.push_back(0.8 * std::exp(-1.4 * centre.back()));
  }
  for (double& p : std::span(density).first(5)) p = 7;  // what lies below 1 plays no part
  EXPECT_NEAR(tail_exponent(centre, density).value, 1.4, 1e-9);
  EXPECT_EQ(tail_exponent(centre, density).n, 45u);
  EXPECT_NEAR(tail_exponent_loglinear(centre, density).value, 1.4, 1e-12);
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
    const Estimate k = tail_exponent(c.centre, c.density), l = tail_exponent_loglinear(c.centre, c.density),
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

TEST(TailExponent, IsMissingWithoutATail) {
  const std::vector<double> centre = {0.5, 1.5, 2.5, 3.5}, none(4, 0.0);
  EXPECT_TRUE(std::isnan(tail_exponent(centre, none).value));
  EXPECT_TRUE(std::isnan(tail_exponent(std::span(centre).first(3), std::vector<double>{1, 1, 1}).value));
  EXPECT_TRUE(std::isnan(tail_exponent_loglinear(centre, std::vector<double>{1, 0.5, 0, 0.2}).value));
  EXPECT_TRUE(std::isnan(tail_exponent_likelihood(std::vector<double>{0.2, 1.0}).value));
  EXPECT_TRUE(std::isnan(tail_exponent_likelihood(1, 0.5).error));
  EXPECT_THROW(tail_exponent(centre, std::vector<double>{1, 2}), Error);
}

}  // namespace
}  // namespace jam
