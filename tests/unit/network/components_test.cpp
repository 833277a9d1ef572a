#include "jamscape/network/components.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "networks.hpp"

namespace jam {
namespace {

using Sizes = std::vector<std::uint32_t>;

// 0 -3- 1 -1- 2 -2- 3   4 -1- 5   6
const WeightedGraph kPath{7, {0, 1, 2, 4}, {1, 2, 3, 5}, {3, 1, 2, 1}};

TEST(Components, at_a_threshold) {
  EXPECT_EQ(components(kPath, 0).size, (Sizes{4, 2, 1}));
  EXPECT_EQ(components(kPath, 1).size, (Sizes{4, 2}));
  EXPECT_EQ(components(kPath, 1.5).size, (Sizes{2, 2}));
  EXPECT_EQ(components(kPath, 3).size, (Sizes{2}));
  EXPECT_EQ(components(kPath, 3.5).count(), 0u);
}

TEST(Components, above_leaves_equal_weights_out) {
  EXPECT_EQ(components(kPath, 1, Level::above).size, (Sizes{2, 2}));
  EXPECT_EQ(components(kPath, 0, Level::above).size, (Sizes{4, 2}));
  EXPECT_EQ(components(kPath, 3, Level::above).count(), 0u);
}

TEST(Components, names_the_component_of_each_vertex) {
  const auto c = components(kPath, 1);
  EXPECT_EQ(c.of, (Sizes{0, 0, 0, 0, 1, 1, Components::kNone}));
  EXPECT_EQ(c.edges, (Sizes{3, 1}));
}

TEST(Components, of_random_graphs_add_up) {
  const auto g = examples::geometric(800, 2, .05, examples::forces(), 3);
  for (const double t : {0., .3, 1., 2.}) {
    const auto c = components(g, t);
    std::uint32_t present = 0;
    for (const auto id : c.of) present += id != Components::kNone;
    EXPECT_EQ(std::accumulate(c.size.begin(), c.size.end(), 0u), present);
    for (std::size_t e = 0; e < g.edges(); ++e) {
      if (g.weight[e] >= t) {
        EXPECT_EQ(c.of[g.from[e]], c.of[g.to[e]]);
      }
    }
    for (std::uint32_t k = 0; k < c.count(); ++k) EXPECT_GE(c.edges[k] + 1, c.size[k]);
  }
}

TEST(Components, of_the_empty_graph) { EXPECT_EQ(components({}, 0).count(), 0u); }

}  // namespace
}  // namespace jam
