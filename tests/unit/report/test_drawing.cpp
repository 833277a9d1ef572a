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
  add_contact(p, 0, 1, 1);
  add_contact(p, 0, -1, 8);  // walls do not count in the mean
  add_contact(p, 1, 2, 3);
  const Drawing d = drawing(p);
  EXPECT_EQ(d.force, (std::vector<double>{0.5, 4, 1.5}));
  EXPECT_EQ(d.ends, (std::vector<std::uint32_t>{0, 1, 0, 3, 1, 2}));
  EXPECT_EQ(d.grains, 3u);
  // A plane wall has no bead: the line ends where the force acts.
  EXPECT_EQ(d.x[3], 0.25);
  EXPECT_EQ(d.radius[3], 0);
}

TEST(Drawing, AttractiveContactsAreNotDrawn) {
  Packing p = box(4);
  for (double x : {0.5, 1.5, 2.5}) add_grain(p, x, 1);
  add_contact(p, 0, 1, 2);
  add_contact(p, 1, 2, -1);
  EXPECT_EQ(drawing(p).lines(), 1u);
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
  const Drawing d = drawing(p);
  EXPECT_EQ(d.beads, 1u);
  EXPECT_EQ(d.extent, (std::array<double, 4>{-0.5, -0.5, 2.5, 2.5}));
  EXPECT_EQ(d.ends, (std::vector<std::uint32_t>{0, 2, 0, 1}));
}

TEST(Drawing, AContactAcrossTheBorderIsDrawnOnBothSides) {
  Packing p = box(3);
  p.domain.periodic = {true, true, false};
  add_grain(p, 0.2, 1);
  add_grain(p, 2.3, 1);
  add_contact(p, 0, 1, 1, {-1, 0, 0});
  const Drawing d = drawing(p);
  ASSERT_EQ(d.lines(), 2u);
  EXPECT_DOUBLE_EQ(d.x[d.ends[1]], 2.3 - 3);
  EXPECT_DOUBLE_EQ(d.x[d.ends[3]], 0.2 + 3);
}

TEST(Drawing, NoContactsNoLines) {
  Packing p = box(3);
  add_grain(p, 1, 1);
  EXPECT_EQ(drawing(p).lines(), 0u);
}

}  // namespace
}  // namespace jam
