#include "jamscape/observe/radial_distribution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "jamscape/geometry/cluster_shape.hpp"
#include "jamscape/observe/pair_correlation.hpp"
#include "packings.hpp"

namespace jam {
namespace {

using namespace test;

MeasureOptions coarse(double range, double bin) {
  MeasureOptions o;
  o.rdf_range = range;
  o.rdf_bin = bin;
  return o;
}

struct Curve {
  std::vector<double> g, error;
};

/// Errors of an ideal gas: of the pairs, and of the number of bodies about the references, which all bins share.
Curve curve(const RadialDistribution& rdf) {
  const auto pairs = rdf.sum(rdf.pairs), ideal = rdf.sum(rdf.ideal);
  Curve c;
  for (std::size_t b = 0; b < pairs.size(); ++b) {
    c.g.push_back(pairs[b] / ideal[b]);
    c.error.push_back(std::sqrt(2 / ideal[b] + 1 / static_cast<double>(rdf.pairs.size())));
  }
  return c;
}

/// Mean square of (g - 1) in errors; about 1 or less where g = 1 within errors.
double misfit(const RadialDistribution& rdf) {
  const Curve c = curve(rdf);
  double sum = 0;
  for (std::size_t b = 0; b < c.g.size(); ++b) sum += std::pow((c.g[b] - 1) / c.error[b], 2);
  return sum / static_cast<double>(c.g.size());
}

TEST(RadialDistribution, OfAnIdealGasIsOneInTwoDimensions) {
  Packing walls = ideal_gas(2, {50, 60, 0}, 9000, false);
  add_walls(walls);
  const RadialDistribution rdf = radial_distribution(walls, coarse(4, 0.2));
  EXPECT_EQ(rdf.margin_sides, 10);
  EXPECT_EQ(rdf.margin_ends, 10);
  EXPECT_NEAR(static_cast<double>(rdf.pairs.size()), 9000. * 30 * 40 / 3000, 200);
  EXPECT_LT(misfit(rdf), 2);
  for (const double g : curve(rdf).g) EXPECT_NEAR(g, 1, 0.15);
  EXPECT_LT(misfit(radial_distribution(ideal_gas(2, {40, 30, 0}, 5000, true), coarse(4, 0.2))), 2);
}

TEST(RadialDistribution, OfAnIdealGasIsOneInThreeDimensionsAndInACylinder) {
  Packing walls = ideal_gas(3, {24, 30, 24}, 14000, false);
  add_walls(walls);
  EXPECT_LT(misfit(radial_distribution(walls, coarse(4, 0.2))), 2);
  const Packing cylinder = ideal_gas_in_cylinder(16, 30, 6000);
  const RadialDistribution rdf = radial_distribution(cylinder, coarse(4, 0.2));
  EXPECT_EQ(rdf.margin_sides, 3);
  EXPECT_EQ(rdf.margin_ends, 10);
  EXPECT_LT(misfit(rdf), 2);
  double dense = 0;
  const Curve c = curve(rdf);
  for (std::size_t b = 5; b < c.g.size(); ++b) dense = std::max(dense, std::abs(c.g[b] - 1));
  EXPECT_LT(dense, 0.1);
}

TEST(RadialDistribution, OfAnIdealGasIsOneInASlab) {
  for (const double thickness : {1.0, 2.0, 5.0}) {
    Packing p = box(3, {30, 40, thickness});
    Random random(3, "ideal gas", 0, "slab");
    for (int k = 0; k < 6000; ++k)
      add_grain(p, {random.uniform(0, 30), random.uniform(0, 40), random.uniform(0, thickness)});
    add_walls(p);
    give_roles(p, 1);
    const RadialDistribution rdf = radial_distribution(p, coarse(4, 0.2));
    EXPECT_EQ(rdf.margin_sides, 0);
    EXPECT_EQ(rdf.margin_ends, 10);
    EXPECT_LT(misfit(rdf), 2) << thickness;
  }
}

TEST(RadialDistribution, MarginsThatLeaveTooLittleAreASixthOfTheWidth) {
  Packing p = ideal_gas(2, {20, 90, 0}, 3000, false);
  add_walls(p);
  const RadialDistribution rdf = radial_distribution(p, {});
  EXPECT_NEAR(rdf.margin_sides, 20 / 6., 1e-12);
  EXPECT_EQ(rdf.margin_ends, 10);
  EXPECT_NEAR(static_cast<double>(rdf.pairs.size()), 3000. * (20 * 2 / 3.) * 70 / (20 * 90), 100);
  MeasureOptions thin;
  thin.rdf_margin_sides = 2;
  EXPECT_EQ(radial_distribution(p, thin).margin_sides, 2);
  EXPECT_NEAR(radial_distribution(ideal_gas_in_cylinder(6, 40, 2000), {}).margin_sides, 1, 1e-12);
  EXPECT_EQ(radial_distribution(ideal_gas_in_cylinder(10, 40, 2000), {}).margin_sides, 3);
}

TEST(RadialDistribution, CountsTheShellsOfAPerfectLattice) {
  const Packing p = hexagonal(20, 20);
  const RadialDistribution rdf = radial_distribution(p, {});
  const auto pairs = rdf.sum(rdf.pairs);
  const auto near = [&](double lo, double hi) {
    double sum = 0;
    for (std::size_t b = 0; b < pairs.size(); ++b)
      if (rdf.distance[b] > lo && rdf.distance[b] < hi) sum += pairs[b];
    return sum / 400;
  };
  EXPECT_EQ(rdf.pairs.size(), 400u);
  EXPECT_EQ(near(0.97, 1.03), 6);
  EXPECT_EQ(near(1.7, 1.76), 6);
  EXPECT_EQ(near(1.97, 2.03), 6);
  EXPECT_EQ(near(2.6, 2.7), 12);
  EXPECT_EQ(near(1.03, 1.7), 0);
}

TEST(RadialDistribution, IsInLengthsOfTheShape) {
  // A chain of crosses at D_1, 2 D_1, ... along x, in a box that is far wider.
  Packing p = box(2, {400, 400, 0}, true);
  p.shapes = {cross_shape(3)};
  const double d1 = 3 * contact_distances(p.shapes[0]).d1;
  for (int k = 0; k < 60; ++k) add_body(p, {1 + d1 * k, 200, 0}, 0, k % 2 == 0 ? 0.9 : 1.1);
  const Snapshot s(p, {});
  const RadialDistribution rdf = radial_distribution(p, {});
  EXPECT_EQ(rdf.length, 3);
  const auto pairs = rdf.sum(rdf.pairs);
  const auto first = std::find_if(pairs.begin(), pairs.end(), [](double n) { return n > 0; }) - pairs.begin();
  EXPECT_NEAR(rdf.distance[static_cast<std::size_t>(first)], d1 / 3, 0.011);
  const Table t = rdf_peaks_measure().evaluate(s);
  EXPECT_NEAR(t.numbers("rdf_peak1")[0], 0.745, 0.011);
  EXPECT_NEAR(t.numbers("rdf_peak2")[0], 1.49, 0.011);
  EXPECT_NEAR(t.numbers("rdf_peak3")[0], 2.236, 0.011);
  EXPECT_NEAR(t.numbers("rdf_d1")[0], 0.745, 5e-4);
  EXPECT_NEAR(t.numbers("rdf_d3")[0], 2.236, 1e-3);
  EXPECT_LT(t.numbers("rdf_peak1_error")[0], 0.01);
  EXPECT_EQ(t.numbers("rdf_references")[0], 60);
}

TEST(RadialDistribution, OfAnIdealGasHasNoPeaks) {
  Packing p = ideal_gas(2, {50, 60, 0}, 5000, false);
  add_walls(p);
  p.packing_fraction = 0;
  const Snapshot s(p, {});
  const Table t = rdf_peaks_measure().evaluate(s);
  for (const char* peak : {"rdf_peak1", "rdf_peak2", "rdf_peak3", "rdf_d1", "rdf_j1"})
    EXPECT_TRUE(std::isnan(t.numbers(peak)[0])) << peak;
}

TEST(RadialDistribution, TableHasCountsThatPool) {
  const Packing p = hexagonal(20, 20);
  const Snapshot s(p, {});
  const Table t = radial_distribution_measure().evaluate(s);
  const auto g = t.numbers("g"), pairs = t.numbers("pairs"), ideal = t.numbers("ideal"), from = t.numbers("references");
  ASSERT_EQ(g.size(), 200u);
  for (std::size_t b = 0; b < g.size(); ++b) {
    EXPECT_DOUBLE_EQ(g[b], pairs[b] / ideal[b]);
    EXPECT_EQ(from[b], 400);
  }
}

TEST(RadialDistribution, WithoutBodiesOrReferences) {
  EXPECT_TRUE(radial_distribution(box(2, {1, 1, 0}), {}).pairs.empty());
  Packing p = box(2, {30, 30, 0});
  add_walls(p);
  add_grain(p, {1, 1, 0});
  EXPECT_TRUE(radial_distribution(p, {}).pairs.empty());
  const Snapshot s(p, {});
  EXPECT_TRUE(std::isnan(radial_distribution_measure().evaluate(s).numbers("g")[0]));
}

TEST(PairCorrelation, OfAnIdealGasIsOneInACylinder) {
  MeasureOptions options;
  options.pair_range = 4;
  options.pair_bin = 0.5;
  const PairCorrelation g = pair_correlation(ideal_gas_in_cylinder(20, 30, 9000), options);
  for (std::size_t b = 1; b < g.g.size(); ++b) EXPECT_NEAR(g.g[b], 1, 0.04) << g.distance[b];
}

}  // namespace
}  // namespace jam
