// Clusters under gravity: fall, and rest on a plane.
#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "cluster_scenes.hpp"

namespace jam {
namespace {

/// One body above a floor across `axis`, gravity .01 down, friction .5.
ClusterSetup above_floor(const ClusterShape& shape, const Quaternion& q, double height, int axis, bool planar = false) {
  ClusterSetup s;
  s.shapes = {shape};
  s.density = 1 / shape.volume;
  s.planar = planar;
  s.bodies.shape = {0};
  s.bodies.position = {Vec3{}};
  s.bodies.position[0][axis] = height;
  s.bodies.orientation = {q};
  s.gravity[axis] = -0.01;
  s.walls = {{.kind = WallKind::plane, .axis = axis, .high = false, .position = 0}};
  s.grain_law = s.wall_law = scenes::s3_law(0.2, 0.5);
  s.dt = 0.02;
  return s;
}

/// Runs long enough to come to rest; the body must then carry its weight on `legs` ends, and have kept its attitude.
void expect_rest(const ClusterSetup& s, std::size_t legs) {
  const int axis = s.walls[0].axis;
  ClusterEngine engine(s);
  engine.run(60000);
  engine.compute_forces();
  const Packing p = engine.record();
  EXPECT_EQ(p.contacts.size(), legs);
  EXPECT_LT(norm(p.grains.velocity[0]), 1e-9);
  EXPECT_LT(norm(p.grains.spin[0]), 1e-9);
  EXPECT_NEAR(engine.wall_force(0)[axis], -0.01, 1e-9);
  const Quaternion turned = conjugate(s.bodies.orientation[0]) * p.grains.orientation[0];
  EXPECT_NEAR(std::abs(turned.w), 1, 1e-8);
  for (std::size_t c = 0; c < p.contacts.size(); ++c)
    EXPECT_NEAR(p.contacts.normal_force[c], 0.01 / static_cast<double>(legs), 1e-8);
  if (s.planar) {
    EXPECT_EQ(p.grains.position[0][2], 0);
    EXPECT_EQ(p.grains.spin[0][0], 0);
    EXPECT_EQ(p.grains.orientation[0].x, 0);
  }
}

TEST(ClusterRest, a_sphere) { expect_rest(above_floor(sphere_shape(), {}, 0.5, 2), 1); }
TEST(ClusterRest, a_rod_lies_flat) { expect_rest(above_floor(rod_shape(4), {}, 0.51, 2), 2); }
TEST(ClusterRest, a_star_stands_on_three_legs) {
  const double h = (star_shape(5).length - 1) / 2;
  // the corner (1, 1, 1) down
  const Quaternion q = scenes::turn_about(cross(Vec3{1, 1, 1}, Vec3{0, 0, -1}), std::acos(-1 / std::sqrt(3.0)));
  expect_rest(above_floor(star_shape(5), q, h / std::sqrt(3.0) + 0.5, 2), 3);
}
TEST(ClusterRest, a_cross_stands_in_the_plane) {
  const double h = (cross_shape(3).length - 1) / 2;
  const Quaternion q = scenes::turn_about({0, 0, 1}, std::numbers::pi / 4);
  expect_rest(above_floor(cross_shape(3), q, h / std::sqrt(2.0) + 0.5, 1, true), 2);
}

TEST(ClusterFall, the_gravity_ledger) {
  ClusterSetup s = above_floor(star_shape(3), {}, 40, 2);
  ClusterEngine engine(s);
  const EnergyLedger start = scenes::now(engine).energy;
  engine.run(1000);
  engine.compute_forces();
  const Packing p = engine.record();
  EXPECT_NEAR(p.grains.position[0][2], 40 - 0.005 * p.time * p.time, 1e-10);
  EXPECT_NEAR(p.energy.kinetic, 0.5 * 1e-4 * p.time * p.time, 1e-12);
  // books begin with half a step of the motion before the start
  EXPECT_NEAR(p.energy.sum(), start.sum(), 1e-12);
}

TEST(ClusterWalls, a_hollow_cylinder_holds_a_rod_by_its_ends) {
  // lying across a cylinder along y with gravity in -z: both tips touch at the same height
  ClusterSetup s = above_floor(rod_shape(6), {}, -3.05, 2);
  s.walls = {{.kind = WallKind::cylinder, .axis = 1, .radius = 5}};
  ClusterEngine engine(s);
  engine.run(60000);
  engine.compute_forces();
  const Packing p = engine.record();
  ASSERT_EQ(p.contacts.size(), 2u);
  EXPECT_NEAR(engine.wall_force(0)[2], -0.01, 1e-8);
  EXPECT_NEAR(engine.wall_force(0)[0], 0, 1e-10);
  for (std::size_t c = 0; c < 2; ++c) {
    const Vec3 tip = p.contacts.point[c];
    EXPECT_NEAR(std::hypot(tip[0], tip[2]), 5 + p.contacts.overlap[c] / 2, 1e-12);
  }
  EXPECT_EQ(p.walls[0].kind, WallKind::cylinder);
  EXPECT_EQ(p.domain.hi[0], 5);
}

TEST(ClusterWalls, a_piston_does_work) {
  ClusterSetup s = above_floor(star_shape(3), {}, 1.6, 2);
  s.gravity = {};
  s.walls.push_back({.kind = WallKind::plane, .axis = 2, .high = true, .position = 3.3, .velocity = -0.001});
  ClusterEngine engine(s);
  const double start = scenes::now(engine).energy.sum();
  engine.run(18000);
  engine.compute_forces();
  Packing p = engine.record();
  EXPECT_NEAR(p.walls[1].position[2], 3.3 - 0.001 * p.time, 1e-11);
  EXPECT_GT(engine.wall_force(1)[2], 0.01);
  EXPECT_GT(p.energy.wall_work, 1e-4);
  EXPECT_NEAR(p.energy.sum(), start, 1e-3 * p.energy.wall_work);
  engine.set_wall_velocity(1, 0);
  engine.advance();
  engine.run(20000);
  engine.compute_forces();
  p = engine.record();
  EXPECT_NEAR(engine.wall_force(1)[2], -engine.wall_force(0)[2], 1e-9);
}

// An end on a plane is a spring until its whole diameter has sunk in: deepest at v sqrt(m/k), after that time times pi/2.
TEST(ClusterRest, an_end_sinks_into_a_plane_by_its_diameter_at_most) {
  ClusterSetup s = above_floor(rod_shape(4), scenes::turn_about({0, 1, 0}, std::numbers::pi / 2), 2, 2);
  s.gravity = {};
  s.wall_law = scenes::s3_law(0, 0);
  s.dt = 1e-4;
  s.bodies.velocity = {Vec3{0, 0, -0.9}};
  ClusterEngine engine(s);
  engine.run(15708);
  engine.compute_forces();
  EXPECT_NEAR(engine.record().contacts.normal_force.at(0), 0.9, 1e-4);
  engine.run(15710);
  engine.compute_forces();
  EXPECT_NEAR(engine.record().grains.velocity[0][2], 0.9, 1e-3);
  s.bodies.velocity = {Vec3{0, 0, -1.1}};
  ClusterEngine faster(s);
  try {
    faster.run(15708);
    FAIL();
  } catch (const Diverged& d) {
    EXPECT_NE(std::string(d.what()).find("beyond the lower wall at z = 0"), std::string::npos) << d.what();
  }
}

}  // namespace
}  // namespace jam
