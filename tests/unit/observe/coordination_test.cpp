#include "jamscape/observe/coordination.hpp"

#include <gtest/gtest.h>

#include "jamscape/geometry/cluster_shape.hpp"
#include "jamscape/observe/backbone.hpp"
#include "jamscape/observe/contacts.hpp"
#include "packings.hpp"

namespace jam {
namespace {

using namespace test;

TEST(Coordination, OfLattices) {
  EXPECT_DOUBLE_EQ(coordination(find_bonds(hexagonal(6, 6))).z, 6);
  EXPECT_DOUBLE_EQ(coordination(find_bonds(square(5, 4))).z, 4);
}

TEST(Coordination, CountsWallsAndRattlersAsItSays) {
  // A chain of three from the left wall, one grain apart from all.
  Packing p = box(2, {10, 4, 0});
  add_walls(p);
  for (const double x : {0.5, 1.5, 2.5, 7.0}) add_grain(p, {x, 2, 0});
  touch(p);
  const Coordination c = coordination(find_bonds(p));
  EXPECT_DOUBLE_EQ(c.z, 2 * 2 / 4.0);
  EXPECT_DOUBLE_EQ(c.z_walls, (2 * 2 + 1) / 4.0);
  EXPECT_DOUBLE_EQ(c.z_multi, 2);         // grains 0 (wall and grain) and 1
  EXPECT_DOUBLE_EQ(c.rattlers, 2 / 4.0);  // grains 2 and 3
}

TEST(Coordination, ClustersThatTouchWithSeveralArmsAreOnePair) {
  Packing p = box(2, {20, 9, 0});
  p.shapes = {cross_shape(4)};
  add_walls(p);
  for (const double x : {3.0, 6.5, 15.0}) add_body(p, {x, 2, 0});
  add_contact_at(p, 0, -3, {2, 0, 0}, {0, -1, 0}, 1);  // two ends of an arm on the floor
  add_contact_at(p, 0, -3, {4, 0, 0}, {0, -1, 0}, 1, {}, 0, 1);
  for (std::uint16_t arm = 0; arm < 3; ++arm) add_contact_at(p, 0, 1, {4.7, 2.0 + arm, 0}, {1, 0, 0}, 2, {}, arm, 0);
  const Bonds bonds = find_bonds(p);
  const Coordination c = coordination(bonds);
  EXPECT_DOUBLE_EQ(c.z, 2 * 1 / 3.0);
  EXPECT_DOUBLE_EQ(c.z_walls, (2 * 1 + 2) / 3.0);
  EXPECT_DOUBLE_EQ(c.rattlers, 2 / 3.0);  // body 1 touches one body, however often
  EXPECT_DOUBLE_EQ(mean_normal_force(Snapshot(p, {})), 6);
}

TEST(Coordination, OfNothing) {
  const Coordination none = coordination(find_bonds(box(2, {1, 1, 0})));
  EXPECT_EQ(none.z, 0);
  EXPECT_EQ(none.rattlers, 0);
  Packing p = box(2, {9, 9, 0});
  add_grain(p, {1, 1, 0});
  EXPECT_EQ(coordination(find_bonds(p)).z_multi, 0);
  EXPECT_EQ(coordination(find_bonds(p)).rattlers, 1);
}

TEST(Backbone, LeavesRattlersOutOnceAndNotRecursively) {
  // Chain 0 - 1 - 2 - 3 from the left wall, 4 alone: 3 and 4 are rattlers, 2 stays with the one contact it has left.
  Packing p = box(2, {10, 4, 0});
  add_walls(p);
  for (const double x : {0.5, 1.5, 2.5, 3.5, 7.0}) add_grain(p, {x, 2, 0});
  touch(p);
  const Backbone b = backbone(p, find_bonds(p));
  EXPECT_EQ(b.grains, 3u);
  EXPECT_DOUBLE_EQ(b.z, 2 * 2 / 3.0);
}

TEST(Backbone, OfLatticesIsTheContactNumber) {
  const Packing p = hexagonal(6, 6);
  EXPECT_DOUBLE_EQ(backbone(p, find_bonds(p)).z, 6);
  EXPECT_EQ(backbone(p, find_bonds(p)).grains, 36u);
}

TEST(Backbone, OfNothing) {
  const Packing p = ideal_gas(2, {50, 50, 0}, 5, false);
  EXPECT_EQ(backbone(p, find_bonds(p)).z, 0);
  EXPECT_EQ(backbone(p, find_bonds(p)).grains, 0u);
}

TEST(Contacts, MeanNormalForceIsTheSameForEitherWeight) {
  Packing p = box(2, {10, 4, 0});
  for (const double x : {1.0, 2.0, 3.0}) add_grain(p, {x, 2, 0});
  add_contact(p, 0, 1, 3, {0, 4, 0});
  add_contact(p, 1, 2, 5);
  MeasureOptions total;
  total.force = EdgeForce::total;
  EXPECT_DOUBLE_EQ(mean_normal_force(Snapshot(p, {})), 4);
  EXPECT_DOUBLE_EQ(mean_normal_force(Snapshot(p, total)), 4);
}

}  // namespace
}  // namespace jam
