#include "jamscape/network/level_sweep.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <limits>

#include "jamscape/base/error.hpp"
#include "jamscape/network/components.hpp"
#include "networks.hpp"

namespace jam {
namespace {

const std::vector<double> kGrid = [] {
  std::vector<double> grid;
  for (int k = 0; k <= 60; ++k) grid.push_back(k / 20.);
  return grid;
}();

WeightedGraph chain(std::uint32_t n, bool closed) {
  WeightedGraph g{n, {}, {}, {}};
  for (std::uint32_t v = 0; v + (closed ? 0 : 1) < n; ++v) {
    g.from.push_back(v);
    g.to.push_back((v + 1) % n);
    g.weight.push_back(1);
  }
  return g;
}

/// The same, threshold by threshold, from the connected pieces and their members.
ClusterLevel one_by_one(const WeightedGraph& g, double threshold, const std::vector<Sides>& touches) {
  const Components pieces = components(g, threshold, Level::above);
  std::vector<unsigned> sides(pieces.count(), 0);
  for (std::uint32_t v = 0; v < g.vertices && !touches.empty(); ++v)
    if (pieces.of[v] != Components::kNone) sides[pieces.of[v]] |= touches[v];
  ClusterLevel l;
  for (std::uint32_t c = 0; c < pieces.count(); ++c) {
    bool through = false;
    for (int a = 0; a < 3; ++a) {
      const unsigned both = low_side(a) | high_side(a);
      if ((sides[c] & both) != both) continue;
      through = l.percolates[static_cast<std::size_t>(a)] = true;
    }
    ++(through ? l.percolating_clusters : l.clusters);
    (through ? l.percolating_vertices : l.cluster_vertices) += pieces.size[c];
    l.shape += static_cast<double>(pieces.edges[c]) / pieces.size[c] / pieces.count();
  }
  return l;
}

void expect_same(const ClusterLevel& a, const ClusterLevel& b) {
  EXPECT_EQ(a.clusters, b.clusters);
  EXPECT_EQ(a.cluster_vertices, b.cluster_vertices);
  EXPECT_EQ(a.percolating_clusters, b.percolating_clusters);
  EXPECT_EQ(a.percolating_vertices, b.percolating_vertices);
  EXPECT_EQ(a.percolates, b.percolates);
  EXPECT_NEAR(a.shape, b.shape, 1e-12);
}

TEST(LevelSweep, EqualsOneThresholdAtATime) {
  ComponentHistory history;  // the same memory for all graphs
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Random random(seed, "level sweep", 0, "sides");
    for (const WeightedGraph& g : {examples::packing(400, 2, .84, 80, seed), examples::packing(300, 3, .66, 80, seed),
                                   examples::geometric(700, 2, .05, examples::levels(21), seed),
                                   examples::erdos_renyi(300, .005, examples::forces(), seed)}) {
      std::vector<Sides> touches(g.vertices, 0);
      for (Sides& s : touches)
        if (random.uniform() < .02) s = static_cast<Sides>(random.below(64));
      const auto levels = level_sweep(g, kGrid, {touches, {}});
      ASSERT_EQ(levels.size(), kGrid.size());
      history.build(g);
      EXPECT_EQ(level_sweep(history, kGrid, touches), levels);  // every bit: sums do not depend on the order of edges
      for (std::size_t k = 0; k < kGrid.size(); ++k) {
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", threshold " << kGrid[k]);
        expect_same(levels[k], one_by_one(g, kGrid[k], touches));
      }
    }
  }
}

TEST(LevelSweep, ShapeOfPathsRingsAndPairs) {
  for (const std::uint32_t n : {2u, 3u, 7u}) EXPECT_EQ(level_sweep(chain(n, false), kGrid)[0].shape, (n - 1.) / n);
  for (const std::uint32_t n : {3u, 8u}) EXPECT_EQ(level_sweep(chain(n, true), kGrid)[0].shape, 1);
  const auto both = examples::side_by_side(chain(4, false), chain(5, true));  // mean over clusters, not over grains
  EXPECT_EQ(level_sweep(both, kGrid)[0].shape, (.75 + 1) / 2);
}

TEST(LevelSweep, AWeightEqualToTheThresholdIsOut) {
  const auto levels = level_sweep(chain(4, false), std::vector<double>{0, .99, 1, 2});
  EXPECT_EQ(levels[0].clusters, 1u);
  EXPECT_EQ(levels[1].cluster_vertices, 4u);
  EXPECT_EQ(levels[2], ClusterLevel{});
  EXPECT_EQ(levels[3], ClusterLevel{});
}

TEST(LevelSweep, AVertexWithoutAnEdgeIsNoClusterAtZeroEither) {
  // 0 -1- 1   2   3 -0- 4: the edge without weight is not above 0.
  const WeightedGraph g{5, {0, 3}, {1, 4}, {1, 0}};
  const std::vector<Sides> touches(5, 63);  // a vertex alone percolates as little as it is a cluster
  const auto level = level_sweep(g, std::vector<double>{0}, {touches, {}})[0];
  EXPECT_EQ(level.percolating_clusters, 1u);
  EXPECT_EQ(level.percolating_vertices, 2u);
  EXPECT_EQ(level.clusters, 0u);
  EXPECT_EQ(level.shape, .5);
}

TEST(LevelSweep, PercolatesFromSideToOppositeSideOnly) {
  const auto g = chain(5, false);
  const auto percolates = [&](Sides first, Sides last) {
    std::vector<Sides> touches(5, 0);
    touches[0] = first;
    touches[4] = last;
    return level_sweep(g, std::vector<double>{0}, {touches, {}})[0].percolates;
  };
  using Axes = std::array<bool, 3>;
  EXPECT_EQ(percolates(low_side(0), high_side(0)), (Axes{true, false, false}));
  EXPECT_EQ(percolates(high_side(1), low_side(1)), (Axes{false, true, false}));
  EXPECT_EQ(percolates(low_side(2), high_side(2)), (Axes{false, false, true}));
  EXPECT_EQ(percolates(low_side(0), high_side(1)), (Axes{}));
  EXPECT_EQ(percolates(high_side(0), low_side(1)), (Axes{}));
  EXPECT_EQ(percolates(low_side(1), low_side(1)), (Axes{}));
  EXPECT_EQ(percolates(static_cast<Sides>(low_side(0) | low_side(1)), static_cast<Sides>(high_side(0) | high_side(1))),
            (Axes{true, true, false}));
}

/// Whether some piece above the threshold winds around each axis: copies given vertex by vertex, then compared.
std::array<bool, 3> winds(const WeightedGraph& g, const std::vector<BoxCopy>& image, double threshold) {
  std::vector<std::vector<std::pair<std::uint32_t, BoxCopy>>> next(g.vertices);
  for (std::size_t e = 0; e < g.edges(); ++e) {
    if (!(g.weight[e] > threshold)) continue;
    next[g.from[e]].push_back({g.to[e], image[e]});
    next[g.to[e]].push_back({g.from[e], {-image[e][0], -image[e][1], -image[e][2]}});
  }
  std::array<bool, 3> found{};
  std::vector<char> met(g.vertices, 0);
  std::vector<BoxCopy> copy(g.vertices);
  for (std::uint32_t root = 0; root < g.vertices; ++root) {
    if (met[root]) continue;
    met[root] = 1;
    for (std::deque<std::uint32_t> queue{root}; !queue.empty(); queue.pop_front()) {
      for (const auto& [v, by] : next[queue.front()]) {
        BoxCopy there = copy[queue.front()];
        for (std::size_t a = 0; a < 3; ++a) there[a] += by[a];
        if (!met[v]) queue.push_back(v), met[v] = 1, copy[v] = there;
        for (std::size_t a = 0; a < 3; ++a) found[a] = found[a] || there[a] != copy[v][a];
      }
    }
  }
  return found;
}

TEST(LevelSweep, WindsAroundAPeriodicBox) {
  const auto ring = chain(4, true);  // the last edge goes from 3 to 0
  const auto level = [&](const std::vector<BoxCopy>& image) {
    return level_sweep(ring, std::vector<double>{0}, {{}, image})[0];
  };
  using Axes = std::array<bool, 3>;
  EXPECT_EQ(level({{}, {}, {}, {}}).percolates, (Axes{}));
  EXPECT_EQ(level({{}, {}, {}, {1, 0, 0}}).percolates, (Axes{true, false, false}));
  EXPECT_EQ(level({{}, {0, -1, 0}, {}, {0, 1, 0}}).percolates, (Axes{}));  // out and back again
  EXPECT_EQ(level({{}, {0, 1, 0}, {}, {0, 1, 1}}).percolates, (Axes{false, true, true}));
  EXPECT_EQ(level({{}, {}, {}, {1, 0, 0}}).percolating_vertices, 4u);
}

TEST(LevelSweep, WindingEqualsASearchFromVertexToVertex) {
  int winding = 0, not_winding = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const auto g = examples::lattice(examples::Lattice::square, 144, .75, examples::forces(), seed);
    Random random(seed, "level sweep", 0, "images");
    std::vector<BoxCopy> image(g.edges());
    for (BoxCopy& copy : image)
      for (auto& c : copy)
        if (random.uniform() < .03) c = random.uniform() < .5 ? 1 : -1;
    const auto levels = level_sweep(g, kGrid, {{}, image});
    for (std::size_t k = 0; k < kGrid.size(); ++k) {
      EXPECT_EQ(levels[k].percolates, winds(g, image, kGrid[k])) << seed << " " << kGrid[k];
      for (const bool p : levels[k].percolates) ++(p ? winding : not_winding);
      EXPECT_EQ(levels[k].clusters + levels[k].percolating_clusters, components(g, kGrid[k], Level::above).count());
    }
  }
  EXPECT_GT(winding, 100);
  EXPECT_GT(not_winding, 100);
}

TEST(LevelSweep, OfNothing) {
  EXPECT_EQ(level_sweep(WeightedGraph{}, kGrid), std::vector<ClusterLevel>(kGrid.size()));
  EXPECT_TRUE(level_sweep(chain(3, true), {}).empty());
}

TEST(LevelSweep, RefusesWhatCannotBe) {
  const auto g = chain(4, false);
  const std::vector<Sides> few(3, 0);
  const std::vector<BoxCopy> image(2);
  EXPECT_THROW(level_sweep(g, kGrid, {few, {}}), Error);
  EXPECT_THROW(level_sweep(g, kGrid, {{}, image}), Error);
  EXPECT_THROW(level_sweep(g, std::vector<double>{0, 1, 1}), Error);
  ComponentHistory history;
  history.build(g);
  EXPECT_THROW(level_sweep(history, kGrid, few), Error);
  EXPECT_THROW(level_sweep(history, std::vector<double>{0, 1, 1}), Error);
  auto bad = g;
  bad.weight[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(level_sweep(bad, kGrid), Error);
}

}  // namespace
}  // namespace jam
