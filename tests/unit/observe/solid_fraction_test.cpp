#include "jamscape/observe/solid_fraction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "jamscape/geometry/cluster_shape.hpp"
#include "jamscape/observe/bond_order.hpp"
#include "jamscape/observe/box.hpp"
#include "jamscape/observe/box_sides.hpp"
#include "jamscape/observe/walls.hpp"
#include "packings.hpp"

namespace jam {
namespace {

using namespace test;

constexpr double pi = std::numbers::pi;

double value(const Packing& p, const char* column) {
  return solid_fraction_measure().evaluate(Snapshot(p, {})).numbers(column).at(0);
}

TEST(SolidFraction, OfCrossesInALayerAsThickAsAnArm) {
  Packing p = box(2, {30, 20, 0});
  p.shapes = {cross_shape(4)};
  add_walls(p);
  add_body(p, {5, 5, 0});
  add_body(p, {15, 5, 0}, 0, 1.2);
  EXPECT_NEAR(value(p, "solid_fraction"), (1 + 1.728) * 5.09292 / (30 * 20 * 1.0), 1e-7);
  EXPECT_NEAR(value(p, "area_fraction"), (1 + 1.44) * (2 * (4 - 1 + pi / 4) - 1) / (30 * 20), 1e-12);
  EXPECT_EQ(value(p, "height"), 20);
}

TEST(SolidFraction, OfStarsInACylinderIsOverItsVolume) {
  Packing p = box(3, {10, 25, 10});
  p.shapes = {star_shape(6)};
  add_cylinder(p);
  for (int k = 0; k < 5; ++k) add_body(p, {5, 3.0 + k, 5});
  EXPECT_NEAR(value(p, "solid_fraction"), 5 * 11.93756 / (pi * 25 * 25), 1e-7);
  EXPECT_EQ(value(p, "area_fraction"), 0);
  EXPECT_EQ(value(p, "height"), 25);
  EXPECT_NEAR(box_volume(p), pi * 25 * 25, 1e-9);
}

TEST(SolidFraction, OfDiscsAndSpheresIsAreaAndVolume) {
  Packing p = box(2, {10, 4, 0});
  for (const double x : {1.0, 3.0}) add_grain(p, {x, 2, 0});
  EXPECT_NEAR(value(p, "solid_fraction"), 2 * pi / 4 / 40, 1e-12);
  EXPECT_DOUBLE_EQ(value(p, "solid_fraction"), value(p, "area_fraction"));
  p.dimension = 3;
  p.domain.hi[2] = 2;
  EXPECT_NEAR(value(p, "solid_fraction"), 2 * pi / 6 / 80, 1e-12);
  EXPECT_EQ(value(box(2, {0, 0, 0}), "solid_fraction"), 0);
}

TEST(SolidFraction, WeightIsWhatAllWallsCarry) {
  // Lid pushed up with 50, floor down with 57, the sides rubbed down with 2 and 1: weight 57 + 3 - 50 = 10.
  Packing p = box(2, {10, 5, 0});
  add_walls(p);
  p.walls[0].force = {-9, -2, 0};
  p.walls[1].force = {9, -1, 0};
  p.walls[2].force = {0.5, -57, 0};
  p.walls[3].force = {-0.5, 50, 0};
  EXPECT_DOUBLE_EQ(weight_over_load(p), 10 / 50.);
  p.walls[3].force = {};
  EXPECT_TRUE(std::isnan(weight_over_load(p)));
  EXPECT_TRUE(std::isnan(weight_over_load(box(2, {1, 1, 0}))));
}

TEST(SolidFraction, DeepestOverlapIsOverAllContacts) {
  Packing p = box(2, {10, 4, 0});
  add_walls(p);
  EXPECT_EQ(value(p, "deepest_overlap"), 0);
  add_grain(p, {0.42, 2, 0});
  add_grain(p, {1.4, 2, 0});
  touch(p);
  EXPECT_NEAR(value(p, "deepest_overlap"), 0.08, 1e-12);
}

TEST(Cylinder, IsNoSideOfTheBox) {
  Packing p = box(3, {10, 20, 10});
  p.shapes = {rod_shape(3)};
  add_cylinder(p);
  add_body(p, {1, 1, 5});
  add_contact_at(p, 0, -2, {1, 0, 5}, {0, -1, 0}, 6);
  EXPECT_EQ(touched_sides(p, find_bonds(p))[0], low_side(1));
  add_contact_at(p, 0, -1, {0, 1, 5}, {-1, 0, 0}, 4);
  EXPECT_EQ(touched_sides(p, find_bonds(p))[0], low_side(1));
  const WallForces f = wall_forces(p, find_bonds(p));
  EXPECT_EQ(f.normal, (std::array<double, 6>{0, 0, 6, 0, 0, 0}));
  EXPECT_NEAR(f.pressure, 6 / (pi * 25) / 2, 1e-12);  // floor and lid
  MeasureOptions options;
  options.force_margin = 0.1;
  const double inside = 5 - 0.1 * 2 * p.grains.radius[0];
  EXPECT_NEAR(wall_forces(p, find_bonds(p), options).pressure, 6 / (pi * inside * inside) / 2, 1e-12);
  EXPECT_EQ(height_axis(p), 1);
  EXPECT_EQ(find_lid(p), &p.walls[2]);
}

TEST(BondOrder, OfClustersIsThatOfTheLinesBetweenTheirCentres) {
  Packing lattice = hexagonal(6, 6), clusters = lattice;
  clusters.shapes = {cross_shape(1.5)};
  clusters.grains.shape.assign(36, 0);
  clusters.grains.scale.assign(36, 1);
  clusters.grains.orientation.assign(36, {});
  for (Vec3& n : clusters.contacts.normal) n = {0.6, 0.8, 0};  // arms touch where they do
  const auto psi6 = [](const Packing& p) {
    return bond_order_measure().evaluate(Snapshot(p, {})).numbers("psi6").at(0);
  };
  EXPECT_NEAR(psi6(clusters), psi6(lattice), 1e-9);
  EXPECT_NEAR(psi6(lattice), 1, 1e-9);
}

}  // namespace
}  // namespace jam
