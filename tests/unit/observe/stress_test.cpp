#include "jamscape/observe/stress.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "jamscape/observe/balance.hpp"
#include "jamscape/observe/kinetic_stress.hpp"
#include "jamscape/observe/walls.hpp"
#include "packings.hpp"

namespace jam {
namespace {

using namespace test;

double pressure(const Packing& p) {
  const auto s = stress(p);
  return -(s[0][0] + s[1][1] + s[2][2]) / p.dimension;
}

// An n^D cubic lattice that just fills its box, pressed equally from all walls with force 2 a contact.
Packing pressed(int dimension, int n) {
  const double side = n;
  Packing p = box(dimension, {side, side, dimension == 3 ? side : 0});
  add_walls(p);
  for (int z = 0; z < (dimension == 3 ? n : 1); ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) add_grain(p, {x + 0.5, y + 0.5, dimension == 3 ? z + 0.5 : 0});
  touch(p);
  for (Wall& w : p.walls) w.force = 2.0 * w.force;
  for (double& f : p.contacts.normal_force) f = 2;
  return p;
}

TEST(Stress, PressureIsTheWallPressureInEquilibrium) {
  for (const int dimension : {2, 3}) {
    const Packing p = pressed(dimension, 4);
    const auto s = stress(p);
    EXPECT_NEAR(s[0][0], -2, 1e-12);
    EXPECT_NEAR(s[1][1], -2, 1e-12);
    EXPECT_NEAR(s[2][2], dimension == 3 ? -2 : 0, 1e-12);
    EXPECT_NEAR(s[0][1], 0, 1e-12);
    EXPECT_NEAR(pressure(p), 2, 1e-12);
    EXPECT_NEAR(wall_forces(p, find_bonds(p)).pressure, 2, 1e-12);
    EXPECT_NEAR(wall_forces(p, find_bonds(p)).virial, 2, 1e-12);
    EXPECT_NEAR(unbalanced_force(p), 0, 1e-12);
  }
}

TEST(Stress, OfAPeriodicLattice) {
  // Contact force f on a square lattice of spacing 1: f per unit length across any line.
  Packing p = square(5, 4);
  for (double& f : p.contacts.normal_force) f = 3;
  EXPECT_NEAR(stress(p)[0][0], -3, 1e-12);
  EXPECT_NEAR(stress(p)[1][1], -3, 1e-12);
  // Hexagonal: sum over the three bonds of a grain of f l (x) l, over its area sqrt(3)/2: trace -3 f/(sqrt(3)/2).
  Packing h = hexagonal(6, 6);
  for (double& f : h.contacts.normal_force) f = 1;
  EXPECT_NEAR(pressure(h), 0.5 * 3 / std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(stress(h)[0][0], stress(h)[1][1], 1e-12);
}

TEST(Stress, OfOneContactByHand) {
  Packing p = box(2, {10, 5, 0});
  add_grain(p, {4, 2, 0});
  add_grain(p, {5, 2, 0});
  add_contact(p, 0, 1, 3, {0, 2, 0});
  const auto s = stress(p);  // f on 0 = (-3, 2), branch (1, 0), V = 50
  EXPECT_DOUBLE_EQ(s[0][0], -3.0 / 50);
  EXPECT_DOUBLE_EQ(s[1][0], 2.0 / 50);
  EXPECT_DOUBLE_EQ(s[0][1], 0);
}

TEST(Stress, TensionIsPositive) {
  Packing p = square(3, 3);
  for (double& f : p.contacts.normal_force) f = -1;
  EXPECT_LT(pressure(p), 0);
}

TEST(WallForces, AreKnownByTheNormalOfTheWall) {
  Packing p = box(2, {10, 5, 0});
  add_walls(p);
  p.walls[0].force = {-4, 1, 0};
  p.walls[1].force = {6, 0, 0};
  p.walls[2].force = {9, -8, 0};
  p.walls[3].force = {0, 2, 0};
  std::swap(p.walls[0], p.walls[3]);
  const WallForces f = wall_forces(p, find_bonds(p));
  EXPECT_EQ(f.normal, (std::array<double, 6>{4, 6, 8, 2, 0, 0}));
  EXPECT_DOUBLE_EQ(f.pressure, (4.0 / 5 + 6.0 / 5 + 8.0 / 10 + 2.0 / 10) / 4);
}

TEST(WallForces, AreZeroWithoutWalls) {
  const Packing p = square(3, 3);
  const WallForces f = wall_forces(p, find_bonds(p));
  EXPECT_EQ(f.normal, (std::array<double, 6>{}));
  EXPECT_EQ(f.pressure, 0);
}

// A disc wedged in the corner: wall x pushes it along x and wall y takes that force up along itself, and the other way
// round. It pushes both walls and presses nothing.
TEST(WallForces, OfAWedgedGrainPressNothing) {
  Packing p = box(2, {10, 10, 0});
  add_walls(p);
  add_grain(p, {0.5, 0.5, 0});
  touch(p);
  ASSERT_EQ(p.contacts.size(), 2u);
  for (std::size_t c = 0; c < 2; ++c) {
    p.contacts.normal_force[c] = 6;
    const Vec3 n = p.contacts.normal[c];
    p.contacts.tangential_force[c] = {-6 * -n[1], -6 * -n[0], 0};
    p.walls[static_cast<std::size_t>(-1 - p.contacts.j[c])].force = 6.0 * n - p.contacts.tangential_force[c];
  }
  EXPECT_NEAR(unbalanced_force(p), 0, 1e-12);
  EXPECT_DOUBLE_EQ(wall_forces(p, find_bonds(p)).pressure, 2 * 6.0 / 10 / 4);
  EXPECT_NEAR(wall_forces(p, find_bonds(p)).virial, pressure(p), 1e-15);
  EXPECT_NEAR(wall_forces(p, find_bonds(p)).virial, 0.03, 1e-15);  // 6 at half a grain from the corner, twice, over D V
  p.domain.periodic[0] = true;
  EXPECT_NEAR(wall_forces(p, find_bonds(p)).virial, 0.06, 1e-15);  // of one axis
  p.domain.periodic[0] = false;
  MeasureOptions away;
  away.force_margin = 1;
  EXPECT_EQ(wall_forces(p, find_bonds(p), away).pressure, 0);
}

TEST(WallForces, AMarginShortensTheWalls) {
  MeasureOptions away;
  away.force_margin = 0.6;
  const Packing p = pressed(2, 4);
  EXPECT_NEAR(wall_forces(p, find_bonds(p), away).pressure, 2 * 2 / 2.8, 1e-12);  // two grains a wall on 4 - 2 x .6
}

TEST(KineticStress, IsThatOfTheMotionWithoutTheDrift) {
  Packing p = box(2, {10, 5, 0});
  add_grain(p, {4, 2, 0});
  add_grain(p, {6, 2, 0});
  p.grains.mass = {1, 3};
  p.grains.velocity = {{4, 1, 0}, {0, 1, 0}};  // drift (1, 1): 3 and -1 along x
  const auto s = kinetic_stress(p);
  EXPECT_DOUBLE_EQ(s[0][0], -(9.0 + 3.0) / 50);
  EXPECT_EQ(s[1][1], 0);
  EXPECT_EQ(s[0][1], 0);
  EXPECT_DOUBLE_EQ(kinetic_stress_measure().evaluate(Snapshot(p, {})).numbers("kinetic_pressure").at(0), 12. / 50 / 2);
}

TEST(UnbalancedForce, CountsTheWeight) {
  Packing p = box(2, {10, 5, 0});
  add_walls(p);
  add_grain(p, {4, 0.5, 0});
  touch(p);
  p.contacts.normal_force[0] = 3;
  p.grains.mass[0] = 1.5;
  EXPECT_DOUBLE_EQ(unbalanced_force(p), 1);
  EXPECT_DOUBLE_EQ(unbalanced_force(p, 2), 0);
  EXPECT_DOUBLE_EQ(unbalanced_force(p, 1), 0.5);
}

TEST(UnbalancedForce, OfASinglePairIsOne) {
  Packing p = box(2, {10, 5, 0});
  add_grain(p, {4, 2, 0});
  add_grain(p, {5, 2, 0});
  EXPECT_TRUE(std::isnan(unbalanced_force(p)));
  add_contact(p, 0, 1, 3, {0, 4, 0});
  EXPECT_DOUBLE_EQ(unbalanced_force(p), 1);
  add_grain(p, {8, 4, 0});  // a grain without contacts is at rest
  EXPECT_DOUBLE_EQ(unbalanced_force(p), 2.0 / 3);
}

}  // namespace
}  // namespace jam
