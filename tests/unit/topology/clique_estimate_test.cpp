#include "jamscape/topology/clique_estimate.hpp"

#include <gtest/gtest.h>

#include "networks.hpp"

namespace jam {
namespace {

WeightedGraph complete(std::uint32_t vertices) {
  WeightedGraph g{vertices, {}, {}, {}};
  for (std::uint32_t a = 0; a < vertices; ++a)
    for (std::uint32_t b = 0; b < a; ++b) {
      g.from.push_back(b);
      g.to.push_back(a);
      g.weight.push_back(a + b);
    }
  return g;
}

TEST(CliqueEstimate, CompleteGraphs) {
  const CliqueEstimate e = estimate_cliques(complete(300), {.max_dimension = 2});
  EXPECT_NEAR(e.cliques, 4455100. + 330791175., 1e3);  // 300 over 3 and over 4
  EXPECT_GT(e.bytes, 28 * 330791175.);
  EXPECT_TRUE(e.large);
  EXPECT_NEAR(estimate_cliques(complete(300), {.max_dimension = 1}).cliques, 4455100., 1);
  EXPECT_FALSE(estimate_cliques(complete(300), {.max_dimension = 1}).large);
  EXPECT_FALSE(estimate_cliques(complete(40), {.max_dimension = 2}).large);
  EXPECT_EQ(estimate_cliques(complete(300), {.max_dimension = 0}).cliques, 0);
  EXPECT_EQ(estimate_cliques(complete(300), {.max_dimension = 4, .triangles = Triangles::keep}).cliques, 0);
}

TEST(CliqueEstimate, RandomGraphs) {
  // 1000 over 3 and over 4 with half of the pairs linked: 2.077e7 and 6.47e8.
  const CliqueEstimate e =
      estimate_cliques(examples::erdos_renyi(1000, .5, examples::levels(6), 3), {.max_dimension = 2});
  EXPECT_NEAR(e.cliques / (2.077e7 + 6.47e8), 1, .1);
  EXPECT_TRUE(e.large);
}

TEST(CliqueEstimate, ContactNetworksAreNotLarge) {
  const WeightedGraph g = examples::geometric(20000, 3, .05, examples::forces(), 1);
  EXPECT_FALSE(estimate_cliques(g, {.max_dimension = 2}).large);
}

TEST(CliqueEstimate, WhatIsNoGraphIsLeftToPersistence) {
  EXPECT_FALSE(estimate_cliques({2, {0, 7}, {1, 1}, {1, 1}}, {.max_dimension = 2}).large);
}

}  // namespace
}  // namespace jam
