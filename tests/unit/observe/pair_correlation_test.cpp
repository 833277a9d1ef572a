#include "jamscape/observe/pair_correlation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "packings.hpp"

namespace jam {
namespace {

using namespace test;

MeasureOptions coarse(double range, double bin = 0.25) {
  MeasureOptions o;
  o.pair_range = range;
  o.pair_bin = bin;
  return o;
}

double deviation_from_one(const PairCorrelation& g) {
  double worst = 0;
  for (std::size_t b = 4; b < g.g.size(); ++b) worst = std::max(worst, std::abs(g.g[b] - 1));
  return worst;
}

TEST(PairCorrelation, OfAnIdealGasIsOneBetweenWalls) {
  const Packing p = ideal_gas(2, {60, 50, 0}, 6000, false);
  const PairCorrelation g = pair_correlation(p, coarse(8));
  ASSERT_EQ(g.g.size(), 32u);
  EXPECT_LT(deviation_from_one(g), 0.03);
}

TEST(PairCorrelation, OfAnIdealGasIsOneInAPeriodicBox) {
  const Packing p = ideal_gas(2, {40, 30, 0}, 4000, true);
  EXPECT_LT(deviation_from_one(pair_correlation(p, coarse(8))), 0.03);
}

TEST(PairCorrelation, OfAnIdealGasIsOneInThreeDimensions) {
  EXPECT_LT(deviation_from_one(pair_correlation(ideal_gas(3, {20, 20, 20}, 6000, false), coarse(4, 0.5))), 0.03);
  EXPECT_LT(deviation_from_one(pair_correlation(ideal_gas(3, {12, 12, 12}, 3000, true), coarse(4, 0.5))), 0.03);
}

// Number of neighbours in a shell, from g: g rho shell.
double neighbours(const PairCorrelation& g, double density, double lo, double hi, double bin) {
  double sum = 0;
  for (std::size_t b = 0; b < g.g.size(); ++b)
    if (g.distance[b] > lo && g.distance[b] < hi) sum += g.g[b] * density * 2 * std::numbers::pi * g.distance[b] * bin;
  return sum;
}

TEST(PairCorrelation, CountsTheShellsOfAHexagonalLattice) {
  const double density = 1 / std::sqrt(0.75);
  const PairCorrelation g = pair_correlation(hexagonal(20, 20), coarse(3, 0.02));
  EXPECT_NEAR(neighbours(g, density, 0.9, 1.1, 0.02), 6, 1e-9);
  EXPECT_NEAR(neighbours(g, density, 1.65, 1.8, 0.02), 6, 1e-9);
  EXPECT_NEAR(neighbours(g, density, 1.9, 2.1, 0.02), 6, 1e-9);
  EXPECT_NEAR(neighbours(g, density, 2.5, 2.75, 0.02), 12, 1e-9);
  EXPECT_NEAR(neighbours(g, density, 1.1, 1.65, 0.02), 0, 1e-12);
}

TEST(PairCorrelation, IsTheSameWhereverThePeriodicBoxIsCut) {
  Packing p = ideal_gas(2, {20, 20, 0}, 300, true);
  const PairCorrelation before = pair_correlation(p, coarse(8));
  for (Vec3& x : p.grains.position) x += Vec3{-7, 33, 0};  // also out of the box: it is taken modulo its length
  const PairCorrelation after = pair_correlation(p, coarse(8));
  for (std::size_t b = 0; b < before.g.size(); ++b) EXPECT_NEAR(after.g[b], before.g[b], 1e-9) << b;
}

TEST(PairCorrelation, DistancesAreInMeanDiameters) {
  Packing p = hexagonal(20, 20);
  for (Vec3& x : p.grains.position) x = 3.0 * x;
  for (double& r : p.grains.radius) r *= 3;
  p.domain.hi = 3.0 * p.domain.hi;
  const PairCorrelation big = pair_correlation(p, coarse(2.9, 0.29)),
                        unit = pair_correlation(hexagonal(20, 20), coarse(2.9, 0.29));
  for (std::size_t b = 0; b < big.g.size(); ++b) EXPECT_NEAR(big.g[b], unit.g[b], 1e-9);
}

TEST(PairCorrelation, SaysWhereItHasNoReferenceGrains) {
  const PairCorrelation g = pair_correlation(ideal_gas(2, {10, 10, 0}, 100, true), coarse(8, 0.5));
  EXPECT_FALSE(std::isnan(g.g[9]));
  EXPECT_TRUE(std::isnan(g.g[10]));  // beyond half the box
  EXPECT_EQ(g.references[10], 0u);
  EXPECT_EQ(g.references[9], 100u);
  EXPECT_TRUE(std::isnan(pair_correlation(box(2, {1, 1, 0}), coarse(1)).g[0]));
}

TEST(PairCorrelation, ReferencesStayAwayFromTheWalls) {
  Packing p = box(2, {30, 30, 0});
  add_walls(p);
  for (const double x : {1.0, 4.0, 15.0, 15.9}) add_grain(p, {x, 15, 0});
  const PairCorrelation g = pair_correlation(p, coarse(8, 1));
  EXPECT_EQ(g.references[0], 3u);  // not the one at 1 < margin 3
  EXPECT_EQ(g.references[2], 3u);  // shell up to 3 about the grain at 4 ends at the wall's first layer (.5)
  EXPECT_EQ(g.references[3], 2u);
}

}  // namespace
}  // namespace jam
