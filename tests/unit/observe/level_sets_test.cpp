#include "jamscape/observe/level_sets.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "jamscape/network/components.hpp"
#include "packings.hpp"

namespace jam {
namespace {

using namespace test;

using Columns = std::map<std::string, std::vector<double>>;

Columns columns(const Packing& p, MeasureOptions options = {}) {
  options.rows_every = 0;
  const Table t = level_sets_measure().evaluate(Snapshot(p, options));
  Columns columns;
  for (const Column& c : t.columns) columns[c.name] = t.numbers(c.name);
  return columns;
}

// A bridge of five grains between the walls along x, forces 4, 2, 2, 4 (wall to wall down to 2), a ring of four with
// forces 3, and a grain alone: ten grains, mean force 3.
Packing bridge_and_ring() {
  Packing p = box(2, {5, 10, 0});
  add_walls(p);
  for (int k = 0; k < 5; ++k) add_grain(p, {0.5 + k, 1, 0});
  for (const Vec3 x : {Vec3{2, 4, 0}, Vec3{3, 4, 0}, Vec3{3, 5, 0}, Vec3{2, 5, 0}}) add_grain(p, x);
  add_grain(p, {2, 8, 0});
  touch(p);
  for (std::size_t c = 0; c < p.contacts.size(); ++c) {
    const std::uint32_t i = p.contacts.i[c];
    p.contacts.normal_force[c] = i > 4 ? 3 : i == 0 || i == 3 ? 4 : 2;
  }
  return p;
}

TEST(LevelSets, OfABridgeAndARing) {
  const Packing p = bridge_and_ring();
  Columns c = columns(p);
  const auto at = [&](double threshold) {
    const auto k = static_cast<std::size_t>(std::lround(threshold / 0.05));
    std::map<std::string, double> row;
    for (const auto& [name, values] : c) row[name] = values.at(k);
    EXPECT_DOUBLE_EQ(row["threshold"], threshold);
    return row;
  };
  ASSERT_EQ(c["threshold"].size(), 61u);
  auto low = at(0);  // everything
  EXPECT_EQ(low["b0"], 2);
  EXPECT_EQ(low["b1"], 1);
  EXPECT_EQ(low["b2"], 0);
  EXPECT_EQ(low["clusters"], 1);
  EXPECT_EQ(low["cluster_grains"], 4);
  EXPECT_DOUBLE_EQ(low["cluster_fraction"], 0.4);
  EXPECT_DOUBLE_EQ(low["mean_cluster"], 0.4);
  EXPECT_EQ(low["percolating_x"], 1);
  EXPECT_EQ(low["percolating_y"], 0);
  EXPECT_EQ(low["percolating_z"], 0);
  EXPECT_DOUBLE_EQ(low["percolating_grains"], 0.5);
  EXPECT_DOUBLE_EQ(low["shape"], (4 / 5. + 1) / 2);
  auto middle = at(0.7);  // the bridge has broken into its two ends; the ring holds
  EXPECT_EQ(middle["b0"], 3);
  EXPECT_EQ(middle["clusters"], 3);
  EXPECT_EQ(middle["cluster_grains"], 8);
  EXPECT_DOUBLE_EQ(middle["mean_cluster"], 8 / 3. / 10);
  EXPECT_EQ(middle["percolating_x"], 0);
  EXPECT_EQ(middle["percolating_grains"], 0);
  EXPECT_DOUBLE_EQ(middle["shape"], (0.5 + 0.5 + 1) / 3);
  EXPECT_EQ(at(1)["clusters"], 2);  // a force equal to the threshold is out
  EXPECT_EQ(at(1)["b1"], 0);
  EXPECT_EQ(at(3)["clusters"], 0);
  EXPECT_EQ(at(3)["mean_cluster"], 0);
  EXPECT_EQ(at(3)["shape"], 0);
}

TEST(LevelSets, VoidsAreHollowOctahedraAndNotFilledTetrahedra) {
  Columns hollow = columns(octahedron()), filled = columns(tetrahedron());
  for (std::size_t k = 0; k < 61; ++k) {
    const double there = hollow["threshold"][k] < 1 ? 1 : 0;
    EXPECT_EQ(hollow["b2"][k], there);
    EXPECT_EQ(hollow["b1"][k], 0);
    EXPECT_EQ(hollow["b0"][k], there);
    EXPECT_EQ(filled["b2"][k], 0);
    EXPECT_EQ(filled["b1"][k], 0);
    EXPECT_EQ(filled["b0"][k], there);
  }
  EXPECT_EQ(hollow["shape"][0], 12 / 6.);
  EXPECT_EQ(filled["shape"][0], 6 / 4.);
}

TEST(LevelSets, HollowTetrahedraAreVoidsToo) {
  MeasureOptions hollow;
  hollow.tetrahedra = Tetrahedra::hollow;
  EXPECT_EQ(columns(tetrahedron())["b2"][0], 0);
  EXPECT_EQ(columns(tetrahedron(), hollow)["b2"][0], 1);
  EXPECT_EQ(columns(octahedron())["b2"][0], 1);
  EXPECT_EQ(columns(octahedron(), hollow)["b2"][0], 1);

  // One edge of the tetrahedron is weaker: .5 against 1.1 mean forces. Above it there are two triangles and no void.
  Packing p = tetrahedron();
  p.contacts.normal_force[4] = 5. / 11;
  Columns c = columns(p, hollow);
  for (std::size_t k = 0; k < c["threshold"].size(); ++k) EXPECT_EQ(c["b2"][k], c["threshold"][k] < 0.5 ? 1 : 0) << k;

  // Five grains that all touch: the triangles alone have 4 voids, of the 5 tetrahedra.
  Packing five = box(3, {4, 4, 4});
  for (int k = 0; k < 5; ++k) add_grain(five, {1 + 0.1 * k, 2, 2});
  for (std::uint32_t i = 0; i < 5; ++i)
    for (std::int32_t j = static_cast<std::int32_t>(i) + 1; j < 5; ++j) add_contact(five, i, j, 1);
  EXPECT_EQ(columns(five)["b2"][0], 0);
  EXPECT_EQ(columns(five, hollow)["b2"][0], 4);
}

/// Grains so many that they join the walls, with random forces.
Packing crowd(int dimension) {
  Packing p = ideal_gas(dimension, {12, 12, 12}, dimension == 2 ? 260 : 1300, false, 8);
  if (dimension == 2) p.domain.hi[2] = 0;
  add_walls(p);
  touch(p);
  Random random(8, "crowd", 0, "forces");
  for (double& f : p.contacts.normal_force) f = -std::log(1 - random.uniform());
  return p;
}

class LevelSetsOfCrowds : public testing::TestWithParam<int> {};

TEST_P(LevelSetsOfCrowds, ClustersOfBothKindsAddUpToB0) {
  for (const bool without_rattlers : {false, true}) {
    const Packing p = crowd(GetParam());
    MeasureOptions options;
    options.remove_rattlers = without_rattlers;
    options.clamp = 0;
    Columns c = columns(p, options);
    const Snapshot s(p, options);
    int broken = 0;
    for (std::size_t k = 0; k < c["threshold"].size(); ++k) {
      const ClusterLevel& level = s.levels()[k];
      EXPECT_EQ(c["b0"][k], level.clusters + level.percolating_clusters);
      EXPECT_EQ(c["b0"][k], components(s.network().graph, c["threshold"][k], Level::above).count());
      EXPECT_LE(c["cluster_fraction"][k] + c["percolating_grains"][k], 1);
      broken += level.percolating_clusters == 0;
    }
    EXPECT_GT(broken, 0);
    EXPECT_LT(broken, 61);
  }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, LevelSetsOfCrowds, testing::Values(2, 3));

TEST(LevelSets, B1InTwoDimensionsIsCyclesLessTriangles) {
  // Discs of a lattice cut by chance: no four touch mutually, so b1 = E - V + b0 - T (S1, S2).
  Packing p = hexagonal(14, 12);
  p.domain.periodic = {};
  Random random(4, "level sets", 0, "forces");
  for (std::size_t c = 0; c < p.contacts.size(); ++c) {
    const bool across = p.contacts.image[c] != std::array<std::int8_t, 3>{};
    p.contacts.normal_force[c] = across ? 0 : -std::log(1 - random.uniform());
  }
  MeasureOptions options;
  options.clamp = 0;
  Columns c = columns(p, options);
  const Snapshot s(p, options);
  const WeightedGraph& g = s.network().graph;
  double loops = 0;
  for (std::size_t k = 0; k < c["threshold"].size(); ++k) {
    std::set<std::uint32_t> vertices;
    std::map<std::uint32_t, std::set<std::uint32_t>> up;
    int edges = 0, triangles = 0;
    for (std::size_t e = 0; e < g.edges(); ++e) {
      if (!(g.weight[e] > c["threshold"][k])) continue;
      ++edges;
      vertices.insert({g.from[e], g.to[e]});
      up[std::min(g.from[e], g.to[e])].insert(std::max(g.from[e], g.to[e]));
    }
    for (const auto& [a, bs] : up)
      for (const std::uint32_t b : bs)
        for (const std::uint32_t d : bs) triangles += b < d && up.count(b) > 0 && up[b].count(d) > 0;
    EXPECT_EQ(c["b1"][k], edges - static_cast<double>(vertices.size()) + c["b0"][k] - triangles) << c["threshold"][k];
    loops += c["b1"][k];
  }
  EXPECT_GT(loops, 100);
}

TEST(LevelSets, OfNothingAreZero) {
  for (const Packing& p : {box(3, {1, 1, 1}), ideal_gas(2, {90, 90, 0}, 9, true)})
    for (const auto& [name, values] : columns(p)) {
      if (name == "threshold") continue;
      for (const double v : values) EXPECT_EQ(v, 0) << name;
    }
}

}  // namespace
}  // namespace jam
