#include "jamscape/observe/persistence_measures.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "jamscape/observe/threshold_grid.hpp"
#include "packings.hpp"

namespace jam {
namespace {

using namespace test;

std::map<std::string, double> row(const Measure& m, const Packing& p) {
  std::map<std::string, double> values;
  const Table t = m.evaluate(Snapshot(p, {}));
  for (const Column& c : t.columns) values[c.name] = t.numbers(c.name).at(0);
  return values;
}

// Four grains in a square with contact forces 4, 3, 2, 1 (mean 2.5): one component from 1.6, one loop from .4.
Packing ring() {
  Packing p = box(2, {10, 10, 0});
  for (const Vec3 x : {Vec3{1, 1, 0}, Vec3{2, 1, 0}, Vec3{2, 2, 0}, Vec3{1, 2, 0}}) add_grain(p, x);
  add_contact(p, 0, 1, 4);
  add_contact(p, 0, 3, 1);
  add_contact(p, 1, 2, 3);
  add_contact(p, 2, 3, 2);
  return p;
}

TEST(PersistenceMeasures, OfARing) {
  auto bins = row(persistence_bins_measure(), ring());
  EXPECT_EQ(bins, (std::map<std::string, double>{{"b0_rough", 0},
                                                 {"b0_strong", 0},
                                                 {"b0_medium", 1},
                                                 {"b0_weak", 0},
                                                 {"b1_rough", 0},
                                                 {"b1_strong", 0},
                                                 {"b1_medium", 0},
                                                 {"b1_weak", 1}}));
  auto total = row(total_persistence_measure(), ring());
  EXPECT_NEAR(total["tp0"], 1.6, 1e-15);
  EXPECT_NEAR(total["tp1"], 0.4, 1e-15);
  EXPECT_EQ(total["tp2"], 0);
}

TEST(PersistenceMeasures, ALifetimeOnTheBorderIsRoughIfTheOptionSaysSo) {
  Packing p = box(2, {40, 10, 0});
  for (const double x : {1.0, 2.0, 5.0, 6.0}) add_grain(p, {x, 1, 0});
  add_contact(p, 0, 1, 1.9);
  add_contact(p, 2, 3, 0.1);
  MeasureOptions s2;
  s2.rough_includes_edge = true;
  ASSERT_EQ(Snapshot(p, {}).diagram().pairs.back().birth, 0.1);
  const auto rough = [&](const MeasureOptions& o) {
    return persistence_bins_measure().evaluate(Snapshot(p, o)).numbers("b0_rough").at(0);
  };
  EXPECT_EQ(rough({}), 0);
  EXPECT_EQ(rough(s2), 1);
}

TEST(PersistenceMeasures, IsolatedGrainsAreRough) {
  EXPECT_EQ(row(persistence_bins_measure(), ideal_gas(2, {50, 50, 0}, 20, false))["b0_rough"], 20);
}

// A triangle of discs, a pair, and a disc alone: the pair and the last are rattlers.
TEST(PersistenceMeasures, RemovedRattlersAreInNoBinAndNoBettiNumber) {
  Packing p = box(2, {20, 10, 0});
  for (const Vec3 x : {Vec3{1, 1, 0}, Vec3{2, 1, 0}, Vec3{1.5, 1.8, 0}, Vec3{8, 1, 0}, Vec3{9, 1, 0}, Vec3{15, 5, 0}})
    add_grain(p, x);
  add_contact(p, 0, 1, 1);
  add_contact(p, 0, 2, 1);
  add_contact(p, 1, 2, 1);
  add_contact(p, 3, 4, 1);
  MeasureOptions without;
  without.remove_rattlers = true;
  const auto value = [&](const Measure& m, const MeasureOptions& o, const char* column) {
    return m.evaluate(Snapshot(p, o)).numbers(column).at(0);
  };
  EXPECT_EQ(value(persistence_bins_measure(), {}, "b0_rough"), 1);
  EXPECT_EQ(value(persistence_bins_measure(), without, "b0_rough"), 0);
  EXPECT_EQ(value(persistence_bins_measure(), without, "b0_medium"), 1);
  EXPECT_EQ(value(betti_measure(), {}, "b0"), 3);
  EXPECT_EQ(value(betti_measure(), without, "b0"), 1);
  EXPECT_EQ(diagram_measure().evaluate(Snapshot(p, without)).rows(), 1u);
}

// Forces of .3, .3 and .6 have the mean .4 and are .75, .75 and 1.5 of it, to the last digit or not.
TEST(PersistenceMeasures, AThresholdHoldsTheForcesOnIt) {
  Packing p = box(2, {20, 10, 0});
  for (int k = 0; k < 4; ++k) add_grain(p, {1.0 + k, 1, 0});
  add_contact(p, 0, 1, .1 + .2);
  add_contact(p, 1, 2, .3);
  add_contact(p, 2, 3, .6);
  const Table t = betti_measure().evaluate(Snapshot(p, {}));
  const std::vector<double> threshold = t.numbers("threshold"), b0 = t.numbers("b0");
  for (std::size_t k = 0; k < threshold.size(); ++k) EXPECT_EQ(b0[k], threshold[k] <= 1.5 ? 1 : 0) << threshold[k];
}

TEST(PersistenceMeasures, OfAHollowOctahedron) {
  const Packing p = octahedron();
  const Table t = betti_measure().evaluate(Snapshot(p, {}));
  const std::vector<double> threshold = t.numbers("threshold"), b2 = t.numbers("b2");
  for (std::size_t k = 0; k < threshold.size(); ++k) EXPECT_EQ(b2[k], threshold[k] <= 1 ? 1 : 0) << threshold[k];
  EXPECT_EQ(row(total_persistence_measure(), p)["tp2"], 1);
  EXPECT_EQ(diagram_measure().evaluate(Snapshot(p, {})).numbers("dimension"), (std::vector<double>{0, 2}));
}

TEST(PersistenceMeasures, DiagramListsEveryPoint) {
  Packing p = ring();
  const Table t = diagram_measure().evaluate(Snapshot(p, {}));
  EXPECT_EQ(t.numbers("dimension"), (std::vector<double>{0, 1}));
  EXPECT_EQ(t.numbers("birth"), (std::vector<double>{1.6, 0.4}));
  EXPECT_EQ(t.numbers("death"), (std::vector<double>{0, 0}));
  EXPECT_EQ(t.numbers("essential"), (std::vector<double>{1, 1}));
}

TEST(PersistenceMeasures, BettiCurveHasTheEulerCharacteristicOfTheLevelSet) {
  // b0 - b1 = V - E + T for a complex of vertices, edges and triangles (no four grains in 2D lattices touch mutually).
  Packing p = hexagonal(8, 6);
  Random random(4, "betti", 0, "forces");
  for (double& f : p.contacts.normal_force) f = random.uniform();
  const Snapshot s(p, {});
  const Table t = betti_measure().evaluate(s);
  const std::vector<double> threshold = t.numbers("threshold"), b0 = t.numbers("b0"), b1 = t.numbers("b1");
  ASSERT_EQ(threshold.size(), 101u);
  const WeightedGraph& g = s.network().graph;
  for (std::size_t k = 0; k < threshold.size(); ++k) {
    std::set<std::uint32_t> vertices;
    std::map<std::uint32_t, std::set<std::uint32_t>> up;
    int edges = 0, triangles = 0;
    for (std::size_t e = 0; e < g.edges(); ++e) {
      if (g.weight[e] < threshold[k]) continue;
      ++edges;
      vertices.insert({g.from[e], g.to[e]});
      up[std::min(g.from[e], g.to[e])].insert(std::max(g.from[e], g.to[e]));
    }
    for (const auto& [a, bs] : up)
      for (const std::uint32_t b : bs)
        for (const std::uint32_t c : bs) triangles += b < c && up.count(b) > 0 && up[b].count(c) > 0;
    // The torus closes in the end: without its last triangle nothing is lost, so b2 = 0 unless all are filled.
    const double b2 = triangles == 96 ? 1 : 0;
    EXPECT_EQ(b0[k] - b1[k] + b2, static_cast<double>(vertices.size()) - edges + triangles) << threshold[k];
  }
}

TEST(PersistenceMeasures, ThresholdsAreTheShortestNumbers) {
  const std::vector<double> grid = threshold_grid(5, 0.05);
  ASSERT_EQ(grid.size(), 101u);
  EXPECT_EQ(grid[7], 0.35);
  EXPECT_EQ(grid[3], 0.15);
  EXPECT_EQ(grid.back(), 5);
  EXPECT_EQ(threshold_grid(1, 0.3).size(), 4u);
}

}  // namespace
}  // namespace jam
