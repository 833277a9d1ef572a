// Clusters as something to draw.
#include <gtest/gtest.h>

#include <cmath>

#include "jamscape/geometry/cluster_shape.hpp"
#include "jamscape/report/drawing.hpp"

namespace jam {
namespace {

/// Two rods side by side between a floor and a lid far above, and one by itself.
Packing rods() {
  Packing p;
  p.domain.hi = {6, 50, 0};
  p.shapes = {rod_shape(3)};
  Grains& g = p.grains;
  for (double y : {0.5, 1.45, 4.0}) {
    g.id.push_back(static_cast<std::int64_t>(g.size()));
    g.species.push_back(0);
    g.radius.push_back(p.shapes[0].circumradius);
    g.mass.push_back(1);
    g.position.push_back({3, y, 0});
    for (auto* list : {&g.velocity, &g.spin, &g.angle}) list->push_back({});
    g.shape.push_back(0);
    g.scale.push_back(1);
    g.orientation.push_back({});
  }
  p.walls.resize(2);
  p.walls[0].normal = {0, 1, 0};
  return p;
}

void add_contact(Packing& p, std::uint32_t i, std::int32_t j, std::uint16_t part_j, double force, Vec3 point) {
  p.contacts.i.push_back(i);
  p.contacts.j.push_back(j);
  p.contacts.part_i.push_back(0);
  p.contacts.part_j.push_back(part_j);
  p.contacts.image.push_back({});
  p.contacts.overlap.push_back(0.05);
  p.contacts.normal_force.push_back(force);
  p.contacts.normal.push_back({0, j < 0 ? -1.0 : 1.0, 0});
  p.contacts.tangential_force.push_back({});
  p.contacts.point.push_back(point);
  p.contacts.sliding.push_back(0);
}

TEST(ClusterDrawing, TwoBodiesAreJoinedByOneLineOfTheSumOfTheirForces) {
  Packing p = rods();
  add_contact(p, 0, -1, 0, 5, {2, 0, 0});
  add_contact(p, 0, -1, 1, 5, {4, 0, 0});
  add_contact(p, 0, 1, 0, 4, {2.5, 1, 0});
  add_contact(p, 0, 1, 1, 6, {3.5, 1, 0});
  const Drawing d = drawing(p, EdgeForce::normal);
  ASSERT_EQ(d.lines(), 3u);
  EXPECT_EQ(d.ends[0], 0u);
  EXPECT_EQ(d.ends[1], 1u);
  EXPECT_EQ(d.force, (std::vector<double>{1, 0.5, 0.5}));  // in units of the pair's 10
  EXPECT_EQ(d.position[d.ends[3]], (Vec3{2, 0, 0}));       // where it meets the floor
}

TEST(ClusterDrawing, StressIsInUnitsOfItsMeanOverAllBodies) {
  Packing p = rods();
  add_contact(p, 0, -1, 0, 10, {3, 0, 0});
  add_contact(p, 0, 1, 0, 10, {3, 0.975, 0});
  const Drawing d = drawing(p, EdgeForce::normal);
  // I_1 = -10 (.5 + .475) and -10 .475; the third body carries nothing
  ASSERT_EQ(d.stress.size(), 3u);
  EXPECT_NEAR(d.stress[0], 3 * 0.975 / 1.45, 1e-12);
  EXPECT_NEAR(d.stress[1], 3 * 0.475 / 1.45, 1e-12);
  EXPECT_EQ(d.stress[2], 0);
}

TEST(ClusterDrawing, ThePictureEndsAboveTheHighestBody) {
  const Packing p = rods();
  EXPECT_DOUBLE_EQ(drawing(p, EdgeForce::normal).upper[1], 4 + p.shapes[0].circumradius);
  Packing pressed = p;
  pressed.domain.hi[1] = 4.4;
  EXPECT_DOUBLE_EQ(drawing(pressed, EdgeForce::normal).upper[1], 4.4);
}

TEST(ClusterDrawing, ACylinderIsDrawn) {
  Packing p = rods();
  p.dimension = 3;
  p.domain.lo[2] = -3;
  p.domain.hi[2] = 3;
  EXPECT_FALSE(drawing(p, EdgeForce::normal).cylinder);
  p.walls[0].kind = WallKind::cylinder;
  p.walls[0].position = {3, 0, 0};
  p.walls[0].radius = 3;
  const auto cylinder = drawing(p, EdgeForce::normal).cylinder;
  ASSERT_TRUE(cylinder);
  EXPECT_EQ(cylinder->axis, 1);
  EXPECT_EQ(cylinder->radius, 3);
}

}  // namespace
}  // namespace jam
