#include "jamscape/topology/betti.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "jamscape/network/components.hpp"
#include "jamscape/topology/total.hpp"
#include "networks.hpp"

namespace jam {
namespace {

/// Cells of the level set at theta, counted one by one: vertices, edges, triangles, tetrahedra, ...
std::vector<std::ptrdiff_t> count_cells(const WeightedGraph& g, double theta) {
  std::vector<std::vector<std::uint32_t>> above(g.vertices);  // neighbours with larger numbers
  std::vector<char> present(g.vertices, theta <= 0);
  for (std::size_t e = 0; e < g.edges(); ++e) {
    if (g.weight[e] < theta) continue;
    above[std::min(g.from[e], g.to[e])].push_back(std::max(g.from[e], g.to[e]));
    present[g.from[e]] = present[g.to[e]] = 1;
  }
  for (auto& list : above) std::sort(list.begin(), list.end());
  std::vector<std::ptrdiff_t> count;
  const auto visit = [&](auto&& self, std::size_t dimension, const std::vector<std::uint32_t>& next) -> void {
    if (!next.empty()) count.resize(std::max(count.size(), dimension + 1), 0);
    for (const auto v : next) {
      ++count[dimension];
      std::vector<std::uint32_t> both;
      std::set_intersection(next.begin(), next.end(), above[v].begin(), above[v].end(), std::back_inserter(both));
      self(self, dimension + 1, both);
    }
  };
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t v = 0; v < g.vertices; ++v) {
    if (present[v]) vertices.push_back(v);
  }
  visit(visit, 0, vertices);
  return count;
}

std::vector<double> thresholds(const WeightedGraph& g) {
  std::vector<double> t{-.5, 0, 1e-9, .1, .25, .5, 1, 1.5, 2, 5};
  for (std::size_t e = 0; e < g.edges(); e += 1 + g.edges() / 20) t.push_back(g.weight[e]);  // exactly at an edge
  return t;
}

/// Euler: V - E + T - ... = b0 - b1 + b2 - ...
void expect_euler(const WeightedGraph& g) {
  const int top = 9;
  const auto d = persistence(g, {.max_dimension = top});
  for (const double theta : thresholds(g)) {
    const auto cells = count_cells(g, theta);
    ASSERT_LE(cells.size(), static_cast<std::size_t>(top) + 1) << "choose a sparser network";
    std::ptrdiff_t euler = 0, from_betti = 0;
    for (std::size_t k = 0; k < cells.size(); ++k) euler += k % 2 == 0 ? cells[k] : -cells[k];
    for (int k = 0; k <= top; ++k) {
      const auto b = static_cast<std::ptrdiff_t>(betti(d, k, theta));
      from_betti += k % 2 == 0 ? b : -b;
    }
    EXPECT_EQ(from_betti, euler) << "theta " << theta;
    EXPECT_EQ(betti(d, 0, theta), components(g, theta).count()) << "theta " << theta;
  }
}

TEST(Betti, agrees_with_counting_cells) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    expect_euler(examples::geometric(300, 2, .07, examples::forces(), seed));
    expect_euler(examples::geometric(200, 3, .18, examples::levels(5), seed));
    expect_euler(examples::packing(200, 2, .88, 60, seed));
    expect_euler(examples::packing(200, 3, .7, 60, seed));
    expect_euler(
        examples::shuffled(examples::lattice(examples::Lattice::fcc, 200, .9, examples::levels(4), seed), 9, 1));
  }
}

TEST(Betti, of_flat_networks_is_cycles_less_triangles) {
  // S1's count for 2D, where four discs never touch each other mutually: b1 = E - V + b0 - T
  const auto g = examples::packing(500, 2, .86, 150, 2);
  const auto d = persistence(g);
  for (const double theta : thresholds(g)) {
    auto cells = count_cells(g, theta);
    cells.resize(4, 0);
    ASSERT_EQ(cells[3], 0);
    const auto b0 = static_cast<std::ptrdiff_t>(betti(d, 0, theta));
    EXPECT_EQ(static_cast<std::ptrdiff_t>(betti(d, 1, theta)), cells[1] - cells[0] + b0 - cells[2]);
  }
}

// square with diagonal (5 4 3 2, 1): one loop from 2 down to 1; and an isolated vertex
const WeightedGraph kSquare{5, {0, 1, 2, 3, 0}, {1, 2, 3, 0, 2}, {5, 4, 3, 2, 1}};

TEST(Betti, is_closed_at_birth_and_open_at_death) {
  const auto d = persistence(kSquare);
  const std::map<double, std::size_t> loops{{-1, 0}, {0, 0}, {1, 0}, {1.0001, 1}, {2, 1}, {2.0001, 0}};
  for (const auto& [theta, expected] : loops) EXPECT_EQ(betti(d, 1, theta), expected) << theta;
  const std::map<double, std::size_t> pieces{{-1, 2}, {0, 2}, {1e-300, 1}, {5, 1}, {5.0001, 0}};
  for (const auto& [theta, expected] : pieces) EXPECT_EQ(betti(d, 0, theta), expected) << theta;
}

TEST(Betti, above_is_open_at_birth_and_closed_at_death) {
  const auto d = persistence(kSquare);
  const std::map<double, std::size_t> loops{{-1, 0}, {0, 0}, {.9999, 0}, {1, 1}, {1.9999, 1}, {2, 0}};
  for (const auto& [theta, expected] : loops) EXPECT_EQ(betti(d, 1, theta, Level::above), expected) << theta;
  const std::map<double, std::size_t> pieces{{-1e-300, 2}, {0, 1}, {4.9999, 1}, {5, 0}};
  for (const auto& [theta, expected] : pieces) EXPECT_EQ(betti(d, 0, theta, Level::above), expected) << theta;
}

TEST(Betti, above_counts_the_pieces_above) {
  const auto g = examples::shuffled(examples::geometric(300, 2, .06, examples::levels(9), 4), 11, 1);
  const auto d = persistence(g);
  for (const double theta : thresholds(g)) {
    if (theta < 0) continue;
    EXPECT_EQ(betti(d, 0, theta, Level::above), components(g, theta, Level::above).count()) << theta;
  }
}

TEST(BettiCurve, equals_betti_at_each_threshold) {
  const auto g = examples::shuffled(examples::geometric(300, 3, .15, examples::levels(30), 5), 7, 2);
  const auto d = persistence(g, {.max_dimension = 2});
  auto grid = thresholds(g);
  for (int i = 0; i <= 100; ++i) grid.push_back(.05 * i);
  for (const Level level : {Level::at_least, Level::above})
    for (const int k : {0, 1, 2, 3}) {
      const auto curve = betti_curve(d, k, grid, level);
      ASSERT_EQ(curve.size(), grid.size());
      for (std::size_t i = 0; i < grid.size(); ++i)
        EXPECT_EQ(curve[i], betti(d, k, grid[i], level)) << k << " " << grid[i];
    }
}

TEST(TotalPersistence, counts_essential_classes_down_to_zero) {
  const auto d = persistence(kSquare);
  EXPECT_EQ(total_persistence(d, 0), 5);
  EXPECT_EQ(total_persistence(d, 1), 1);
  EXPECT_EQ(total_persistence(d, 2), 0);
}

TEST(TotalPersistence, is_the_area_under_the_betti_curve) {
  const auto g = examples::geometric(300, 2, .1, examples::levels(33), 5);  // values on a grid of 1/32: sums are exact
  const auto d = persistence(g);
  for (const int k : {0, 1}) {
    double area = 0;
    for (int i = 1; i <= 32; ++i) area += static_cast<double>(betti(d, k, i / 32.)) / 32;
    EXPECT_EQ(total_persistence(d, k), area);
  }
}

}  // namespace
}  // namespace jam
