#include "jamscape/stats/histogram.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

TEST(Histogram, CountsAtTheEdges) {
  Histogram h(Spacing::linear, 0, 4, 4);
  for (const double x : {-0.1, 0.0, 0.5, 1.0, 3.9, 4.0, 4.1}) h.add(x);
  h.add(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(h.counts(), (std::vector<std::int64_t>{2, 1, 0, 2}));
  EXPECT_EQ(h.below(), 1);
  EXPECT_EQ(h.above(), 2);
  EXPECT_EQ(h.total(), 8);
  EXPECT_EQ(h.centres(), (std::vector<double>{0.5, 1.5, 2.5, 3.5}));
}

TEST(Histogram, DecimalEdgesHoldTheirValuesHoweverRounded) {
  Histogram h(Spacing::linear, 0, 10, 50);  // edges .2 k, the third .6000000000000001
  for (int k = 0; k < 50; ++k) {
    h.add(.2 * k);
    h.add(k / 5.);
    h.add((k + 1) / 5. - .2);
  }
  for (const std::int64_t count : h.counts()) EXPECT_EQ(count, 3);
}

TEST(Histogram, DensityIntegratesToTheFractionInside) {
  Histogram h(Spacing::logarithmic, 0.1, 10, 7);
  for (int k = 1; k <= 1000; ++k) h.add(0.013 * k);
  double integral = 0;
  const std::vector<double> d = h.density();
  for (std::size_t k = 0; k < h.bins(); ++k) integral += d[k] * (h.edges()[k + 1] - h.edges()[k]);
  const double outside = static_cast<double>(h.below() + h.above()) / static_cast<double>(h.total());
  EXPECT_GT(h.below(), 0);
  EXPECT_GT(h.above(), 0);
  EXPECT_NEAR(integral + outside, 1, 1e-12);
}

TEST(Histogram, LogarithmicBinsHaveEqualRatios) {
  const Histogram h(Spacing::logarithmic, 0.1, 100, 3);
  EXPECT_NEAR(h.edges()[1], 1, 1e-14);
  EXPECT_NEAR(h.edges()[2], 10, 1e-13);
  EXPECT_NEAR(h.centres()[0], std::sqrt(0.1), 1e-14);
}

TEST(Histogram, EmptyHasNoDensity) {
  EXPECT_EQ(Histogram(Spacing::linear, 0, 1, 2).density(), (std::vector<double>{0, 0}));
}

TEST(Histogram, RefusesImpossibleBins) {
  EXPECT_THROW(Histogram(Spacing::linear, 1, 1, 3), Error);
  EXPECT_THROW(Histogram(Spacing::linear, 0, 1, 0), Error);
  EXPECT_THROW(Histogram(Spacing::logarithmic, 0, 1, 3), Error);
  EXPECT_THROW(Histogram(Spacing::linear, 0, std::numeric_limits<double>::infinity(), 3), Error);
}

}  // namespace
}  // namespace jam
