#include "jamscape/network/triangles.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "jamscape/base/random.hpp"

namespace jam {
namespace {

std::vector<double> sorted(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values;
}

TEST(Triangles, HaveTheSmallestWeightOfTheirEdges) {
  EXPECT_EQ(triangle_weights({3, {0, 2, 1}, {1, 0, 2}, {3, 2, 5}}), (std::vector<double>{2}));
  EXPECT_TRUE(triangle_weights({4, {0, 1, 2, 3}, {1, 2, 3, 0}, {1, 1, 1, 1}}).empty());  // a square
  // K4: 01:6 02:5 03:4 12:3 13:2 23:1
  EXPECT_EQ(sorted(triangle_weights({4, {0, 0, 0, 1, 1, 2}, {1, 2, 3, 2, 3, 3}, {6, 5, 4, 3, 2, 1}})),
            (std::vector<double>{1, 1, 2, 3}));
  EXPECT_TRUE(triangle_weights({}).empty());
}

TEST(Triangles, OfARandomGraphAreThoseOfAllTriples) {
  Random random(2, "triangles", 0, "graph");
  const std::uint32_t n = 30;
  std::vector<double> matrix(n * n, -1);
  WeightedGraph g{n, {}, {}, {}};
  for (std::uint32_t a = 0; a < n; ++a)
    for (std::uint32_t b = a + 1; b < n; ++b) {
      if (random.uniform() > 0.3) continue;
      const double weight = random.uniform() < 0.1 ? 0 : random.uniform();
      const bool turned = random.uniform() < 0.5;
      g.from.push_back(turned ? b : a);
      g.to.push_back(turned ? a : b);
      g.weight.push_back(weight);
      matrix[a * n + b] = weight;
    }
  std::vector<double> expected;
  for (std::uint32_t a = 0; a < n; ++a)
    for (std::uint32_t b = a + 1; b < n; ++b)
      for (std::uint32_t c = b + 1; c < n; ++c) {
        const double least = std::min({matrix[a * n + b], matrix[a * n + c], matrix[b * n + c]});
        if (least >= 0) expected.push_back(least);
      }
  EXPECT_GT(expected.size(), 50u);
  EXPECT_EQ(sorted(triangle_weights(g)), sorted(expected));
}

}  // namespace
}  // namespace jam
