#include "jamscape/observe/force_network.hpp"

#include <gtest/gtest.h>

#include "jamscape/base/error.hpp"
#include "jamscape/observe/balance.hpp"
#include "jamscape/observe/contact_forces.hpp"
#include "jamscape/observe/snapshot.hpp"
#include "packings.hpp"

namespace jam {
namespace {

using namespace test;

// Four grains in a row along x; contacts as each test wants them.
Packing row(int grains) {
  Packing p = box(2, {10, 4, 0});
  for (int k = 0; k < grains; ++k) add_grain(p, {1.0 + k, 2, 0});
  return p;
}

TEST(ForceNetwork, WeightsAreForcesOverTheirMean) {
  Packing p = row(4);
  add_contact(p, 0, 1, 1);
  add_contact(p, 1, 2, 2);
  add_contact(p, 2, 3, 3);
  const Snapshot s(p, {});
  EXPECT_EQ(s.network().mean_force, 2);
  EXPECT_EQ(s.network().graph.vertices, 4u);
  EXPECT_EQ(s.network().graph.weight, (std::vector<double>{0.5, 1, 1.5}));
  EXPECT_EQ(s.network().graph.from, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(s.network().graph.to, (std::vector<std::uint32_t>{1, 2, 3}));
  EXPECT_EQ(s.network().contact, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(ForceNetwork, ClampsAfterNormalising) {
  Packing p = row(11);
  for (std::uint32_t k = 0; k < 9; ++k) add_contact(p, k, static_cast<std::int32_t>(k) + 1, 1);
  add_contact(p, 9, 10, 91);
  EXPECT_EQ(Snapshot(p, {}).network().graph.weight.back(), 5);
  EXPECT_EQ(Snapshot(p, {}).network().force.back(), 91);
  MeasureOptions whole;
  whole.clamp = 0;
  EXPECT_EQ(Snapshot(p, whole).network().graph.weight.back(), 9.1);
}

TEST(ForceNetwork, AttractionCountsByItsMagnitude) {
  Packing p = row(3);
  add_contact(p, 0, 1, -1);
  add_contact(p, 1, 2, 3);
  EXPECT_EQ(Snapshot(p, {}).network().graph.weight, (std::vector<double>{0.5, 1.5}));
}

TEST(ForceNetwork, TotalForceHasTheTangentialPart) {
  Packing p = row(3);
  add_contact(p, 0, 1, 3, {0, 4, 0});
  add_contact(p, 1, 2, 5);
  MeasureOptions total;
  total.force = EdgeForce::total;
  EXPECT_EQ(Snapshot(p, {}).network().mean_force, 4);
  EXPECT_EQ(Snapshot(p, total).network().mean_force, 5);
  EXPECT_EQ(Snapshot(p, total).network().graph.weight, (std::vector<double>{1, 1}));
}

TEST(ForceNetwork, SeparatedGrainsAndWallsAreNoEdges) {
  Packing p = row(3);
  add_walls(p);
  p.grains.position[2][0] += 0.01;
  p.grains.position[0][0] = 0.4;
  add_contact(p, 0, -1, 7);
  p.grains.position[1][0] = 1.3;
  add_contact(p, 0, 1, 1);
  p.grains.position[2][0] = 2.31;
  add_contact(p, 1, 2, 0);
  const Snapshot s(p, {});
  EXPECT_EQ(s.network().graph.edges(), 1u);
  EXPECT_EQ(s.network().mean_force, 1);
  EXPECT_EQ(s.bonds().wall_contact.size(), 1u);
}

// Positions rounded to three digits, forces in full: what carries a force is a contact, in every measure.
TEST(ForceNetwork, AContactWithAForceIsThereAcrossARoundedGap) {
  Packing p = row(4);
  p.grains.position[2][0] = 3.001;
  p.grains.position[3][0] = 4.002;
  add_contact(p, 0, 1, 2);
  add_contact(p, 1, 2, 4);
  add_contact(p, 2, 3, 0);
  ASSERT_LT(p.contacts.overlap[1], 0);
  ASSERT_LT(p.contacts.overlap[2], 0);
  const Snapshot s(p, {});
  EXPECT_EQ(s.network().force, (std::vector<double>{2, 4}));
  EXPECT_EQ(contact_forces(p), (std::vector<double>{2, 4}));
  EXPECT_EQ(s.bonds().grains, (std::vector<std::uint32_t>{1, 2, 1, 0}));
  EXPECT_DOUBLE_EQ(unbalanced_force(p), ((2 + 2 + 4 + 0) / 4.) / 3);  // over two contacts, not three
}

TEST(ForceNetwork, SeveralContactsOfAPairAreOneEdgeWithTheirVectorSum) {
  Packing p = row(3);
  add_contact(p, 0, 1, 3);
  add_contact(p, 0, 1, 4);
  p.contacts.part_j[1] = 1;
  p.contacts.normal[1] = {0, 1, 0};
  add_contact(p, 1, 2, 5);
  const Snapshot s(p, {});
  EXPECT_EQ(s.network().force, (std::vector<double>{5, 5}));
  EXPECT_EQ(s.network().contact, (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(s.bonds().grains, (std::vector<std::uint32_t>{1, 2, 1}));
}

TEST(ForceNetwork, RattlersGoOnceAndNotRecursively) {
  // 0 - 1 - 2 - 3 - 4, closed triangle at the end (2, 3, 4): grain 0 is a rattler; grain 1 becomes one but stays.
  Packing p = row(5);
  p.grains.position[4] = {3.5, 2 + std::sqrt(0.75), 0};
  p.grains.position[3] = {4, 2, 0};
  add_contact(p, 0, 1, 9);
  add_contact(p, 1, 2, 1);
  add_contact(p, 2, 3, 2);
  add_contact(p, 2, 4, 3);
  add_contact(p, 3, 4, 2);
  MeasureOptions options;
  options.remove_rattlers = true;
  const ForceNetwork net = Snapshot(p, options).network();
  EXPECT_EQ(net.contact, (std::vector<std::uint32_t>{1, 2, 3, 4}));
  EXPECT_EQ(net.mean_force, 2);
  EXPECT_EQ(net.graph.vertices, 4u);  // grain 0 is no vertex
  EXPECT_EQ(net.grain, (std::vector<std::uint32_t>{1, 2, 3, 4}));
  EXPECT_EQ(net.graph.from, (std::vector<std::uint32_t>{0, 1, 1, 2}));
  EXPECT_EQ(net.graph.to, (std::vector<std::uint32_t>{1, 2, 3, 3}));
  EXPECT_EQ(Snapshot(p, {}).network().graph.vertices, 5u);
}

TEST(ForceNetwork, AGrainThatLosesItsEdgesToRattlersStaysAVertex) {
  Packing p = row(4);  // grain 1 touches two walls and a rattler: it stays, and no edge with it
  add_walls(p);
  add_contact(p, 0, 1, 1);
  add_contact(p, 1, -2, 1);
  add_contact(p, 1, -1, 1);
  MeasureOptions options;
  options.remove_rattlers = true;
  EXPECT_EQ(Snapshot(p, options).network().graph.vertices, 1u);
  EXPECT_EQ(Snapshot(p, options).network().grain, (std::vector<std::uint32_t>{1}));
  EXPECT_EQ(Snapshot(p, options).network().grains, 1u);
  EXPECT_EQ(Snapshot(p, options).levels().front().clusters, 0u);
}

TEST(ForceNetwork, AWallContactKeepsAGrainFromBeingARattler) {
  Packing p = row(2);
  add_walls(p);
  p.grains.position[0][0] = 0.5;
  p.grains.position[1][0] = 1.5;
  add_contact(p, 0, -1, 1);
  add_contact(p, 0, 1, 1);
  MeasureOptions options;
  options.remove_rattlers = true;
  EXPECT_EQ(Snapshot(p, options).network().graph.edges(), 0u);  // grain 1 has one contact
  p.walls[1].position[0] = 2;
  add_contact(p, 1, -2, 1);
  EXPECT_EQ(Snapshot(p, options).network().graph.edges(), 1u);
}

TEST(ForceNetwork, WithoutContactsOrForces) {
  Packing p = row(3);
  EXPECT_EQ(Snapshot(p, {}).network().graph.edges(), 0u);
  EXPECT_EQ(Snapshot(p, {}).network().mean_force, 0);
  add_contact(p, 0, 1, 0);
  EXPECT_EQ(Snapshot(p, {}).network().graph.weight, (std::vector<double>{0}));
}

TEST(ForceNetwork, RefusesContactsThatCannotBe) {
  Packing p = row(3);
  add_contact(p, 1, 2, 1);
  add_contact(p, 0, 1, 1);
  EXPECT_THROW(Snapshot(p, {}).network(), Error);  // not sorted
  p.contacts.i = {0, 1};
  p.contacts.j = {1, 3};
  EXPECT_THROW(Snapshot(p, {}).network(), Error);  // no grain 3
  p.contacts.j = {1, -1};
  EXPECT_THROW(Snapshot(p, {}).network(), Error);  // no wall
  p.contacts.i = {0, 2};
  p.contacts.j = {1, 1};
  EXPECT_THROW(Snapshot(p, {}).network(), Error);  // i > j
}

TEST(ForceNetwork, PeriodicNeighboursAreEdges) {
  const Packing p = hexagonal(6, 6);
  const Snapshot s(p, {});
  EXPECT_EQ(s.network().graph.edges(), 3u * 36u);
  for (const std::uint32_t degree : s.bonds().grains) EXPECT_EQ(degree, 6u);
}

}  // namespace
}  // namespace jam
