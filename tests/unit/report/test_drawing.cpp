#include <gtest/gtest.h>

#include "jamscape/report/drawing.hpp"

namespace jam {
namespace {

void add_grain(Packing& p, double x, double y) {
  p.grains.id.push_back(static_cast<std::int64_t>(p.grains.size()));
  p.grains.species.push_back(0);
  p.grains.radius.push_back(0.5);
  p.grains.mass.push_back(1);
  p.grains.position.push_back({x, y, 0});
  for (auto* list : {&p.grains.velocity, &p.grains.spin, &p.grains.angle}) list->push_back({});
}

void add_contact(Packing& p, std::uint32_t i, std::int32_t j, double force, std::array<std::int8_t, 3> image = {}) {
  p.contacts.i.push_back(i);
  p.contacts.j.push_back(j);
  p.contacts.part_i.push_back(0);
  p.contacts.part_j.push_back(1);
  p.contacts.image.push_back(image);
  p.contacts.overlap.push_back(0.01);
  p.contacts.normal_force.push_back(force);
  p.contacts.normal.push_back({1, 0, 0});
  p.contacts.tangential_force.push_back({});
  p.contacts.point.push_back({0.25, 0.75, 0});
  p.contacts.sliding.push_back(0);
}

Packing box(double side) {
  Packing p;
  p.domain.hi = {side, side, 0};
  return p;
}

TEST(Drawing, ForcesAreInUnitsOfTheMeanBetweenGrains) {
  Packing p = box(4);
  for (double x : {0.5, 1.5, 2.5}) add_grain(p, x, 1);
  p.walls.push_back({});
  add_contact(p, 0, -1, 8);  // walls do not count in the mean
  add_contact(p, 0, 1, 1);
  add_contact(p, 1, 2, 3);
  const Drawing d = drawing(p, EdgeForce::normal);
  EXPECT_EQ(d.force, (std::vector<double>{4, 0.5, 1.5}));
  EXPECT_EQ(d.ends, (std::vector<std::uint32_t>{0, 3, 0, 1, 1, 2}));
  EXPECT_EQ(d.grains, 3u);
  // A plane wall has no bead: the line ends where the force acts.
  EXPECT_EQ(d.position[3], (Vec3{0.25, 0.75, 0}));
  EXPECT_EQ(d.radius[3], 0);
}

TEST(Drawing, AttractiveContactsAreNotDrawn) {
  Packing p = box(4);
  for (double x : {0.5, 1.5, 2.5}) add_grain(p, x, 1);
  add_contact(p, 0, 1, 2);
  add_contact(p, 1, 2, -1);
  EXPECT_EQ(drawing(p, EdgeForce::normal).lines(), 1u);
}

TEST(Drawing, BeadsOutsideThePictureAreLeftOut) {
  Packing p = box(2);
  add_grain(p, 0.6, 1);
  add_grain(p, 1.5, 1);
  Wall wall;
  wall.kind = WallKind::beads;
  wall.bead_radius = 0.5;
  wall.beads = {{0, -1.5, 0}, {0, 1, 0}, {0, 9, 0}};
  p.walls.push_back(wall);
  add_contact(p, 0, -1, 1);
  add_contact(p, 0, 1, 1);
  const Drawing d = drawing(p, EdgeForce::normal);
  EXPECT_EQ(d.beads, 1u);
  EXPECT_EQ(d.lower, (Vec3{-0.5, -0.5, 0}));
  EXPECT_EQ(d.upper, (Vec3{2.5, 2.5, 0}));
  EXPECT_EQ(d.ends, (std::vector<std::uint32_t>{0, 2, 0, 1}));
}

TEST(Drawing, AContactAcrossTheBorderIsDrawnOnBothSides) {
  Packing p = box(3);
  p.domain.periodic = {true, true, false};
  add_grain(p, 0.2, 1);
  add_grain(p, 2.3, 1);
  add_contact(p, 0, 1, 1, {-1, 0, 0});
  const Drawing d = drawing(p, EdgeForce::normal);
  ASSERT_EQ(d.lines(), 2u);
  // Each line ends at the border it crosses.
  EXPECT_DOUBLE_EQ(d.position[d.ends[1]][0], 0);
  EXPECT_DOUBLE_EQ(d.position[d.ends[3]][0], 3);
}

TEST(Drawing, GrainsThatWanderedOutOfThePeriodicBoxAreDrawnInside) {
  Packing p = box(3);
  p.dimension = 3;
  p.domain.hi[2] = 3;
  p.domain.periodic = {true, true, true};
  add_grain(p, 0.2 + 6, 1);
  add_grain(p, 0.9, 1 - 3);
  add_contact(p, 0, 1, 1, {2, 1, 0});
  const Drawing d = drawing(p, EdgeForce::normal);
  EXPECT_NEAR(d.position[0][0], 0.2, 1e-12);
  EXPECT_NEAR(d.position[1][1], 1, 1e-12);
  EXPECT_EQ(d.ends, (std::vector<std::uint32_t>{0, 1}));  // one line, none across the border
}

TEST(Drawing, ALineAcrossAnEdgeEndsAtTheNearestFace) {
  Packing p = box(3);
  p.dimension = 3;
  p.domain.hi[2] = 3;
  p.domain.periodic = {true, true, true};
  add_grain(p, 2.8, 2.6);
  add_grain(p, 0.2, 0.4);
  add_contact(p, 0, 1, 1, {1, 1, 0});
  const Drawing d = drawing(p, EdgeForce::normal);
  ASSERT_EQ(d.lines(), 2u);
  const Vec3 end = d.position[d.ends[1]];
  EXPECT_NEAR(end[0], 3, 1e-12);
  EXPECT_NEAR(end[1], 2.6 + 0.8 * 0.2 / 0.4, 1e-12);
}

TEST(Drawing, TheTotalForceHasItsTangentialPart) {
  Packing p = box(4);
  for (double x : {0.5, 1.5, 2.5}) add_grain(p, x, 1);
  add_contact(p, 0, 1, 3);
  add_contact(p, 1, 2, 5);
  p.contacts.tangential_force[0] = {0, 4, 0};
  EXPECT_EQ(drawing(p, EdgeForce::total).force, (std::vector<double>{1, 1}));
  EXPECT_EQ(drawing(p, EdgeForce::normal).force, (std::vector<double>{0.75, 1.25}));
}

TEST(Drawing, NoContactsNoLines) {
  Packing p = box(3);
  add_grain(p, 1, 1);
  EXPECT_EQ(drawing(p, EdgeForce::normal).lines(), 0u);
}

}  // namespace
}  // namespace jam
