#include "jamscape/observe/percolation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "packings.hpp"

namespace jam {
namespace {

using namespace test;

std::map<std::string, double> row(const Packing& p, const MeasureOptions& options = {}) {
  const Table t = percolation_measure().evaluate(Snapshot(p, options));
  std::map<std::string, double> values;
  for (const Column& c : t.columns) values[c.name] = t.numbers(c.name).at(0);
  return values;
}

TEST(PercolationEstimate, OfEqualDegrees) {
  EXPECT_DOUBLE_EQ(percolation_estimate({3, 3, 3, 3}), 0.5);
  EXPECT_DOUBLE_EQ(percolation_estimate({6, 6, 6}), 0.2);
  EXPECT_DOUBLE_EQ(percolation_estimate({2, 2, 2}), 1);
}

TEST(PercolationEstimate, IsTheRatioOfMomentsWhateverIsIsolated) {
  const double k1 = (1 + 2 + 5) / 3., k2 = (1 + 4 + 25) / 3.;
  EXPECT_DOUBLE_EQ(percolation_estimate({1, 2, 5}), k1 / (k2 - k1));
  EXPECT_DOUBLE_EQ(percolation_estimate({1, 0, 2, 0, 0, 5}), k1 / (k2 - k1));
}

TEST(PercolationEstimate, IsMissingWithoutASecondContact) {
  EXPECT_TRUE(std::isnan(percolation_estimate({1, 1, 0})));
  EXPECT_TRUE(std::isnan(percolation_estimate({})));
}

TEST(Percolation, OfAColumnBetweenWalls) {
  Packing p = box(2, {9, 3, 0});
  add_walls(p);
  for (int k = 0; k < 3; ++k) add_grain(p, {4, 0.5 + k, 0});
  add_grain(p, {7, 1.5, 0});
  touch(p);
  auto all = row(p);
  EXPECT_EQ(all["percolates_x"], 0);
  EXPECT_EQ(all["percolates_y"], 1);
  EXPECT_EQ(all["percolates_z"], 0);
  EXPECT_EQ(all["percolates"], 1);
  EXPECT_EQ(all["percolating_fraction"], 0.75);
  EXPECT_EQ(all["mean_degree"], 2 * 2 / 4.);
  EXPECT_DOUBLE_EQ(all["percolation_estimate"], 4 / 2.);
  MeasureOptions options;
  options.remove_rattlers = true;
  EXPECT_EQ(row(p, options)["mean_degree"], 2 * 2 / 3.);
  EXPECT_EQ(row(p, options)["percolating_fraction"], 0.75);  // N stays the number of all grains
}

TEST(Percolation, NeedsPositiveForces) {
  Packing p = box(2, {9, 3, 0});
  add_walls(p);
  for (int k = 0; k < 3; ++k) add_grain(p, {4, 0.5 + k, 0});
  touch(p);
  Packing between = p, wall = p;
  for (std::size_t c = 0; c < p.contacts.size(); ++c)
    if (p.contacts.j[c] == 1)
      between.contacts.normal_force[c] = 0;
    else if (p.contacts.j[c] < 0 && p.contacts.i[c] == 0)
      wall.contacts.normal_force[c] = 0;
  EXPECT_EQ(row(p)["percolates"], 1);
  EXPECT_EQ(row(between)["percolates"], 0);
  EXPECT_EQ(row(between)["mean_degree"], 2 * 1 / 3.);
  EXPECT_EQ(row(wall)["percolates"], 0);
}

TEST(Percolation, AroundPeriodicBoxes) {
  auto all = row(square(4, 3));
  EXPECT_EQ(all["percolates_x"], 1);
  EXPECT_EQ(all["percolates_y"], 1);
  EXPECT_EQ(all["percolates_z"], 0);
  EXPECT_EQ(all["percolating_fraction"], 1);
  EXPECT_DOUBLE_EQ(all["percolation_estimate"], 4 / 12.);
  Packing p = box(2, {4, 9, 0}, true);  // one row around x
  for (int k = 0; k < 4; ++k) add_grain(p, {0.5 + k, 4, 0});
  touch(p);
  EXPECT_EQ(row(p)["percolates_x"], 1);
  EXPECT_EQ(row(p)["percolates_y"], 0);
  p.domain.hi[0] = 4.5;  // the row no longer closes
  p.contacts = {};
  touch(p);
  EXPECT_EQ(row(p)["percolates"], 0);
}

}  // namespace
}  // namespace jam
