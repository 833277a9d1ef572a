#include "jamscape/observe/force_distribution.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "jamscape/observe/snapshot.hpp"
#include "packings.hpp"

namespace jam {
namespace {

using namespace test;

TEST(ForceDistribution, IntegralAndFractionOutsideMakeOne) {
  const Packing p = cloud(2, 800, 5);
  const Snapshot s(p, {});
  const Histogram h = force_distribution(s.packing(), s.network(), s.options());
  EXPECT_EQ(h.total(), static_cast<std::int64_t>(s.network().graph.edges()));
  double integral = 0;
  const auto d = h.density();
  for (std::size_t b = 0; b < h.bins(); ++b) integral += d[b] * (h.edges()[b + 1] - h.edges()[b]);
  EXPECT_GT(h.below() + h.above(), 0);
  EXPECT_NEAR(integral + static_cast<double>(h.below() + h.above()) / static_cast<double>(h.total()), 1, 1e-12);
}

TEST(ForceDistribution, OfExponentialForcesIsExponential) {
  const Packing p = cloud(2, 4000, 6);
  const Snapshot s(p, {});
  const Histogram h = force_distribution(s.packing(), s.network(), s.options());
  const auto centre = h.centres(), density = h.density();
  for (std::size_t b = 10; b < 35; ++b) EXPECT_NEAR(density[b] / std::exp(-centre[b]), 1, 0.2) << centre[b];
}

TEST(ForceDistribution, IsNotClamped) {
  Packing p = box(2, {40, 4, 0});
  for (int k = 0; k < 21; ++k) add_grain(p, {1.0 + k, 2, 0});
  for (std::uint32_t k = 0; k < 20; ++k) add_contact(p, k, static_cast<std::int32_t>(k) + 1, k == 7 ? 81 : 1);
  MeasureOptions wide;
  wide.force_max = 20;
  EXPECT_EQ(force_distribution(p, Snapshot(p, wide).network(), wide).above(), 0);
  EXPECT_EQ(force_distribution(p, Snapshot(p, {}).network(), {}).above(), 1);  // 81/5 = 16.2 mean forces
}

TEST(ForceDistribution, InLinearBinsFromZero) {
  const Packing p = cloud(2, 4000, 6);
  MeasureOptions linear;
  linear.force_scale = ForceScale::linear;
  linear.force_min = 0;
  linear.force_max = 6;
  linear.force_bins = 30;
  const Histogram h = force_distribution(p, Snapshot(p, linear).network(), linear);
  EXPECT_EQ(h.below(), 0);
  for (std::size_t b = 0; b < h.bins(); ++b) EXPECT_NEAR(h.edges()[b + 1] - h.edges()[b], 0.2, 1e-12);
  EXPECT_NEAR(h.centres()[3], 0.7, 1e-12);
  for (std::size_t b = 0; b < 10; ++b) EXPECT_NEAR(h.density()[b] / std::exp(-h.centres()[b]), 1, 0.15);
}

TEST(ForceDistribution, OfNothing) {
  const Packing p = box(2, {1, 1, 0});
  EXPECT_EQ(force_distribution(p, Snapshot(p, {}).network(), {}).total(), 0);
}

}  // namespace
}  // namespace jam
