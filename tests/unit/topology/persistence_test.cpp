#include "jamscape/topology/persistence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <thread>
#include <tuple>

#include "jamscape/base/error.hpp"
#include "networks.hpp"

namespace jam {
namespace {

struct Edge {
  std::uint32_t i, j;
  double f;
};

WeightedGraph network(std::uint32_t vertices, const std::vector<Edge>& edges) {
  WeightedGraph g{vertices, {}, {}, {}};
  for (const auto& [i, j, f] : edges) {
    g.from.push_back(i);
    g.to.push_back(j);
    g.weight.push_back(f);
  }
  return g;
}

/// "4 e" essential, born at 4; "4 1" born at 4, dead at 1.
std::multiset<std::string> points(const Diagram& d, int dimension) {
  std::multiset<std::string> found;
  for (const auto& p : d.pairs) {
    if (p.dimension != dimension) continue;
    const auto text = [](double x) { return testing::PrintToString(x); };
    found.insert(text(p.birth) + (p.essential ? " e" : " " + text(p.death)));
    if (p.essential) {
      EXPECT_EQ(p.death, 0);
    }
  }
  return found;
}

using Points = std::multiset<std::string>;

Diagram diagram(const WeightedGraph& g, int max_dimension = 2) {
  return persistence(g, {.max_dimension = max_dimension});
}

WeightedGraph octahedron() {
  std::vector<Edge> edges;
  for (std::uint32_t i = 0; i < 6; ++i) {
    for (std::uint32_t j = i + 1; j < 6; ++j) {
      if (i / 2 != j / 2) edges.push_back({i, j, 1});
    }
  }
  return network(6, edges);
}

WeightedGraph complete(std::uint32_t n) {
  std::vector<Edge> edges;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = i + 1; j < n; ++j) edges.push_back({i, j, 1});
  }
  return network(n, edges);
}

// The golden cases of theory sec. 4.

TEST(Golden, square_is_a_loop_that_never_dies) {
  const auto d = diagram(network(4, {{0, 1, 4}, {1, 2, 3}, {2, 3, 2}, {3, 0, 1}}));
  EXPECT_EQ(points(d, 0), Points{"4 e"});
  EXPECT_EQ(points(d, 1), Points{"1 e"});
}

TEST(Golden, triangle_is_filled_at_once) {
  const auto g = network(3, {{0, 1, 3}, {1, 2, 2}, {2, 0, 1}});
  EXPECT_EQ(points(diagram(g), 0), Points{"3 e"});
  EXPECT_EQ(points(diagram(g), 1), Points{});
  EXPECT_EQ(points(persistence(g, {.triangles = Triangles::keep}), 1), Points{"1 e"});
}

TEST(Golden, diagonal_fills_a_square) {
  const auto d = diagram(network(4, {{0, 1, 5}, {1, 2, 4}, {2, 3, 3}, {3, 0, 2}, {0, 2, 1}}));
  EXPECT_EQ(points(d, 0), Points{"5 e"});
  EXPECT_EQ(points(d, 1), Points{"2 1"});
}

TEST(Golden, path) {
  const auto d = diagram(network(4, {{0, 1, 3}, {1, 2, 1}, {2, 3, 2}}));
  EXPECT_EQ(points(d, 0), (Points{"3 e", "2 1"}));
  EXPECT_EQ(points(d, 1), Points{});
}

TEST(Golden, spokes_fill_a_hexagon) {
  std::vector<Edge> edges;
  for (std::uint32_t i = 0; i < 6; ++i) {
    edges.push_back({i, (i + 1) % 6, 2});
    edges.push_back({i, 6, 1});
  }
  const auto d = diagram(network(7, edges));
  EXPECT_EQ(points(d, 0), Points{"2 e"});
  EXPECT_EQ(points(d, 1), Points{"2 1"});
  EXPECT_EQ(points(d, 2), Points{});
}

TEST(Golden, octahedron_is_hollow) {
  const auto d = diagram(octahedron());
  EXPECT_EQ(points(d, 0), Points{"1 e"});
  EXPECT_EQ(points(d, 1), Points{});
  EXPECT_EQ(points(d, 2), Points{"1 e"});
}

TEST(Golden, four_mutual_neighbours_are_filled) {
  const auto d = diagram(complete(4));
  EXPECT_EQ(points(d, 1), Points{});
  EXPECT_EQ(points(d, 2), Points{});
}

TEST(Golden, two_isolated_and_a_pair) {
  const auto d = diagram(network(4, {{1, 2, 1}}));
  EXPECT_EQ(points(d, 0), (Points{"1 e", "0 e", "0 e"}));
  EXPECT_EQ(d.pairs.size(), 3u);
}

TEST(Golden, cross_polytope_of_four_dimensions_is_a_three_sphere) {
  std::vector<Edge> edges;
  for (std::uint32_t i = 0; i < 8; ++i) {
    for (std::uint32_t j = i + 1; j < 8; ++j) {
      if (i / 2 != j / 2) edges.push_back({i, j, 2. + i + .1 * j});
    }
  }
  const auto d = persistence(network(8, edges), {.max_dimension = 5});
  EXPECT_EQ(points(d, 3).size(), 1u);
  EXPECT_EQ(points(d, 4).size() + points(d, 5).size(), 0u);
}

TEST(Golden, no_edges_and_no_vertices) {
  EXPECT_TRUE(diagram({}).pairs.empty());
  EXPECT_EQ(points(diagram(network(3, {})), 0), (Points{"0 e", "0 e", "0 e"}));
}

TEST(Golden, contacts_without_force) {
  // 2 - 3 touch at force 0: one component of value 0; the vertex that joins dies where it was born.
  const auto g = network(5, {{0, 1, 1}, {2, 3, 0}});
  EXPECT_EQ(points(diagram(g), 0), (Points{"1 e", "0 e", "0 e"}));
  EXPECT_EQ(persistence(g, {.keep_zero_length = true}).pairs.size(), 5u);
}

TEST(Cells, are_reported_with_their_values) {
  // the square with a diagonal: edge 3 (3 - 0) closes the loop, triangle 0 2 3 ends it
  const auto d = diagram(network(4, {{0, 1, 5}, {1, 2, 4}, {2, 3, 3}, {3, 0, 2}, {0, 2, 1}}), 1);
  ASSERT_EQ(d.pairs.size(), 2u);
  EXPECT_EQ(d.pairs[0].birth_cell, 0);  // the older of the two vertices of value 5
  EXPECT_EQ(d.pairs[0].death_cell, -1);
  EXPECT_EQ(d.pairs[1].birth_cell, 3);
  EXPECT_EQ(d.pairs[1].death_cell, 1);  // 0 1 2 enters with it, as number 0
  ASSERT_EQ(d.cliques.size(), 1u);
  EXPECT_EQ(d.cliques[0].size(), 3u);
}

/// Every pair's cells exist, have the right dimension and the pair's values, and no cell is used twice.
void expect_cells_match(const WeightedGraph& g, const Diagram& d) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> weight;
  std::vector<double> value(g.vertices, 0);
  for (std::size_t e = 0; e < g.edges(); ++e) {
    weight[std::minmax(g.from[e], g.to[e])] = g.weight[e];
    for (const auto v : {g.from[e], g.to[e]}) value[v] = std::max(value[v], g.weight[e]);
  }
  std::set<std::pair<int, CellId>> used, listed;
  for (const auto& p : d.pairs) {
    listed.emplace(p.dimension, p.birth_cell);
    if (!p.essential) listed.emplace(p.dimension + 1, p.death_cell);
  }
  std::map<std::pair<int, CellId>, std::size_t> place;  // in the list of cliques of its dimension
  std::map<int, std::size_t> count;
  for (const auto& cell : listed) place[cell] = count[cell.first]++;
  const auto value_of = [&](int dimension, CellId id) {
    EXPECT_TRUE(used.emplace(dimension, id).second);
    if (dimension == 0) return value.at(static_cast<std::size_t>(id));
    if (dimension == 1) return g.weight.at(static_cast<std::size_t>(id));
    const std::size_t i = place.at({dimension, id});
    const auto k = static_cast<std::size_t>(dimension);
    const auto& all = d.cliques.at(k - 2);
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t p = i * (k + 1); p < (i + 1) * (k + 1); ++p) {
      for (std::size_t q = p + 1; q < (i + 1) * (k + 1); ++q) {
        EXPECT_LT(all.at(p), all.at(q));
        smallest = std::min(smallest, weight.at({all[p], all[q]}));
      }
    }
    return smallest;
  };
  for (const auto& p : d.pairs) {
    EXPECT_EQ(value_of(p.dimension, p.birth_cell), p.birth);
    if (p.essential) {
      EXPECT_EQ(p.death_cell, -1);
    } else {
      EXPECT_EQ(value_of(p.dimension + 1, p.death_cell), p.death);
    }
  }
  std::size_t cliques = 0, in_pairs = 0;
  for (std::size_t k = 2; k < d.cliques.size() + 2; ++k) cliques += d.cliques[k - 2].size() / (k + 1);
  for (const auto& [dimension, id] : used) in_pairs += dimension >= 2;
  EXPECT_EQ(cliques, in_pairs);
}

TEST(Cells, keep_their_numbers_whatever_is_asked_for) {
  for (const auto& g : {examples::geometric(150, 3, .25, examples::forces(), 1),
                        examples::erdos_renyi(40, .5, examples::levels(6), 2)}) {
    const Diagram most = persistence(g, {3, Triangles::fill, true});
    for (const int dimension : {0, 1, 2}) {
      const Diagram d = persistence(g, {dimension, Triangles::fill, true});
      for (std::size_t k = 0; k < d.pairs.size(); ++k) {
        ASSERT_EQ(d.pairs[k].birth_cell, most.pairs[k].birth_cell);
        ASSERT_EQ(d.pairs[k].death_cell, most.pairs[k].death_cell);
      }
    }
  }
}

TEST(Cells, of_random_networks_match_their_pairs) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    for (const bool zero : {false, true}) {
      for (const int dimension : {0, 1, 2, 3}) {
        const PersistenceOptions options{dimension, Triangles::fill, zero};
        for (const auto& g : {examples::geometric(150, 3, .25, examples::forces(), seed),
                              examples::shuffled(examples::geometric(200, 2, .12, examples::levels(4), seed), 5, seed),
                              examples::erdos_renyi(60, .5, examples::levels(6), seed)}) {
          expect_cells_match(g, persistence(g, options));
        }
      }
    }
  }
}

TEST(Cells, zero_length_pairs_complete_the_account) {
  // Every vertex is born; every edge ends a component or begins a loop.
  const auto g = examples::geometric(300, 2, .1, examples::levels(5), 8);
  const auto d = persistence(g, {.keep_zero_length = true});
  const auto count = [&](int dimension, bool essential) {
    return std::count_if(d.pairs.begin(), d.pairs.end(),
                         [&](const auto& p) { return p.dimension == dimension && p.essential == essential; });
  };
  EXPECT_EQ(count(0, true) + count(0, false), static_cast<std::ptrdiff_t>(g.vertices));
  EXPECT_EQ(count(0, false) + count(1, true) + count(1, false), static_cast<std::ptrdiff_t>(g.edges()));
}

TEST(Order, by_dimension_then_birth_then_cell) {
  for (const bool zero : {false, true}) {
    const auto g = examples::shuffled(examples::geometric(250, 3, .2, examples::levels(3), 2), 20, 1);
    const auto d = persistence(g, {.max_dimension = 2, .keep_zero_length = zero});
    const auto key = [](const PersistencePair& p) { return std::tuple(p.dimension, -p.birth, p.birth_cell); };
    for (std::size_t i = 1; i < d.pairs.size(); ++i) EXPECT_LT(key(d.pairs[i - 1]), key(d.pairs[i]));
  }
}

std::vector<Points> all_points(const Diagram& d) { return {points(d, 0), points(d, 1), points(d, 2)}; }

TEST(Invariance, points_do_not_depend_on_numbering) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    for (const auto& g : {examples::packing(200, 2, .88, 60, seed), examples::packing(150, 3, .7, 40, seed),
                          examples::geometric(150, 3, .25, examples::levels(4), seed)}) {
      const auto expected = all_points(diagram(g));
      EXPECT_EQ(all_points(diagram(examples::shuffled(g, 0, seed + 50))), expected);
    }
  }
}

TEST(Invariance, scaling_weights_by_a_power_of_two_scales_points) {
  auto g = examples::packing(200, 2, .88, 60, 1);
  const auto before = diagram(g);
  for (auto& w : g.weight) w *= 4;
  const auto after = diagram(g);
  ASSERT_EQ(before.pairs.size(), after.pairs.size());
  for (std::size_t i = 0; i < before.pairs.size(); ++i) {
    EXPECT_EQ(4 * before.pairs[i].birth, after.pairs[i].birth);
    EXPECT_EQ(4 * before.pairs[i].death, after.pairs[i].death);
    EXPECT_EQ(before.pairs[i].birth_cell, after.pairs[i].birth_cell);
  }
}

void expect_identical(const Diagram& a, const Diagram& b) {
  ASSERT_EQ(a.pairs.size(), b.pairs.size());
  EXPECT_EQ(a.cliques, b.cliques);
  for (std::size_t i = 0; i < a.pairs.size(); ++i) {
    const auto key = [](const PersistencePair& p) {
      return std::tuple(p.dimension, p.birth, p.death, p.essential, p.birth_cell, p.death_cell);
    };
    ASSERT_EQ(key(a.pairs[i]), key(b.pairs[i]));
  }
}

TEST(Workspace, never_influences_a_result) {
  PersistenceWorkspace workspace;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    for (const int dimension : {2, 0, 3, 1}) {
      for (const auto& g : {examples::erdos_renyi(50, .7, examples::levels(9), seed), complete(9), WeightedGraph{},
                            examples::geometric(200, 3, .2, examples::forces(), seed)}) {
        const PersistenceOptions options{dimension, Triangles::fill, false};
        expect_identical(persistence(g, options, workspace), persistence(g, options));
      }
    }
  }
}

TEST(Workspace, is_usable_after_an_error) {
  PersistenceWorkspace workspace;
  const auto bad = network(4, {{0, 1, 2}, {1, 2, 2}, {2, 0, 2}, {3, 0, 1}, {1, 0, 1}});
  EXPECT_THROW(persistence(bad, {}, workspace), Error);
  const auto g = examples::packing(200, 2, .88, 40, 1);
  expect_identical(persistence(g, {}, workspace), persistence(g));
}

TEST(Threads, give_the_same_pairs) {
  const auto g = examples::packing(400, 3, .7, 30, 4);
  const auto expected = diagram(g);
  std::vector<Diagram> found(4);
  std::vector<std::thread> threads;
  for (auto& d : found) threads.emplace_back([&] { d = diagram(g); });
  for (auto& t : threads) t.join();
  for (const auto& d : found) expect_identical(d, expected);
}

TEST(BadInput, is_named) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const int dimension : {0, 1, 2}) {
    EXPECT_THROW(diagram(network(3, {{0, 1, -1}}), dimension), Error);
    EXPECT_THROW(diagram(network(3, {{0, 1, nan}}), dimension), Error);
    EXPECT_THROW(diagram(network(3, {{0, 3, 1}}), dimension), Error);
    EXPECT_THROW(diagram(network(3, {{1, 1, 1}}), dimension), Error);
    EXPECT_THROW(diagram(network(3, {{0, 1, 1}, {1, 2, 1}, {1, 0, 2}}), dimension), Error);
    EXPECT_THROW(diagram(network(3, {{0, 1, 1}, {0, 1, 1}}), dimension), Error);
  }
  EXPECT_THROW(persistence({}, {.max_dimension = -1}), Error);
}

TEST(BadInput, repeated_edges_are_found_at_hubs_too) {
  auto g = complete(60);
  g.from.push_back(33);
  g.to.push_back(12);
  g.weight.push_back(.5);
  EXPECT_THROW(diagram(g, 1), Error);
  g.weight.back() = 2;
  EXPECT_THROW(diagram(g, 1), Error);
}

}  // namespace
}  // namespace jam
