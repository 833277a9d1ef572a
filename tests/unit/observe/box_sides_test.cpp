#include "jamscape/observe/box_sides.hpp"

#include <gtest/gtest.h>

#include "jamscape/observe/snapshot.hpp"
#include "packings.hpp"

namespace jam {
namespace {

using namespace test;

TEST(BoxSides, AWallStandsWhereItsNormalSays) {
  Packing p = box(3, {3, 3, 3});
  add_walls(p);
  for (int side = 0; side < 6; ++side) EXPECT_EQ(wall_side(p.walls[static_cast<std::size_t>(side)], 3), side);
}

TEST(BoxSides, AGrainInTheCornerTouchesEveryWallThere) {
  Packing p = box(3, {3, 3, 3});
  add_walls(p);
  add_grain(p, {0.5, 2.5, 0.5});
  add_grain(p, {1.5, 1.5, 2.5});
  add_grain(p, {1.5, 1.5, 1.5});
  touch(p);
  const auto sides = touched_sides(p, find_bonds(p));
  EXPECT_EQ(sides, (std::vector<Sides>{static_cast<Sides>(low_side(0) | high_side(1) | low_side(2)), high_side(2), 0}));
}

TEST(BoxSides, TouchingNeedsAForceAndNoOverlap) {
  Packing p = box(2, {3, 3, 0});
  add_walls(p);
  for (const double y : {0.5, 1.5, 2.5}) add_grain(p, {0.5, y, 0});
  add_contact(p, 0, -1, 1);
  add_contact(p, 1, -1, 0);
  add_contact(p, 2, -1, 1);
  p.contacts.overlap[2] = -0.01;
  EXPECT_EQ(touched_sides(p, find_bonds(p)), (std::vector<Sides>{low_side(0), 0, low_side(0)}));
}

TEST(BoxSides, ImagesAreThoseOfTheEdges) {
  const Packing p = square(4, 3);
  const Snapshot s(p, {});
  const auto images = edge_images(p, s.network());
  ASSERT_EQ(images.size(), 24u);
  for (std::size_t e = 0; e < images.size(); ++e) {
    const auto& stored = p.contacts.image[s.network().contact[e]];
    EXPECT_EQ(images[e], (BoxCopy{stored[0], stored[1], stored[2]}));
  }
  EXPECT_TRUE(edge_images(box(2, {1, 1, 0}), {}).empty());
}

}  // namespace
}  // namespace jam
