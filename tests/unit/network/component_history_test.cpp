#include "jamscape/network/component_history.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Pairs merges(const ComponentHistory& history) {
  Pairs pairs;
  for (const auto& m : history.merges()) pairs.emplace_back(m.kept, m.lost);
  return pairs;
}

// Two pairs 5-3 and 1-4, joined by 3-4; 1-5 closes the loop; 0 and 2 have no edge.
const WeightedGraph kLoop{6, {1, 3, 4, 1}, {5, 5, 1, 3}, {1, 4, 3, 2}};

TEST(ComponentHistory, RanksEdgesAndNumbersVerticesAsTheyEnter) {
  ComponentHistory history;
  history.build(kLoop);
  ASSERT_EQ(history.edges(), 4u);
  const std::uint32_t edges[] = {1, 2, 3, 0};
  for (std::uint32_t r = 0; r < 4; ++r) {
    EXPECT_EQ(history.edge(r), edges[r]);
    EXPECT_EQ(history.weight(r), 4 - r);
    EXPECT_EQ(history.ends()[r].a, kLoop.from[edges[r]]);
    EXPECT_EQ(history.ends()[r].b, kLoop.to[edges[r]]);
  }
  EXPECT_EQ(history.vertices().name, (std::vector<std::uint32_t>{3, 5, 1, 4}));
  EXPECT_EQ(history.vertices().entry, (std::vector<std::uint32_t>{0, 0, 1, 1}));
  EXPECT_EQ(history.isolated(), (std::vector<std::uint32_t>{0, 2}));
}

TEST(ComponentHistory, OfTwoComponentsTheYoungerIsLost) {
  ComponentHistory history;
  history.build(kLoop);
  EXPECT_EQ(merges(history), (Pairs{{0, 1}, {2, 3}, {0, 2}, {0, 0}}));
}

TEST(ComponentHistory, VerticesOfOneValueEnterByTheirNumber) {
  ComponentHistory history;
  const WeightedGraph path{4, {3, 2, 0}, {2, 0, 1}, {1, 1, 1}};
  history.build(path);
  EXPECT_EQ(history.vertices().name, (std::vector<std::uint32_t>{0, 1, 2, 3}));
  EXPECT_EQ(history.vertices().entry, (std::vector<std::uint32_t>(4, 0)));
  EXPECT_EQ(merges(history), (Pairs{{2, 3}, {0, 2}, {0, 1}}));
}

TEST(ComponentHistory, MemoryOfALargerGraphIsNotSeen) {
  ComponentHistory history;
  history.build(kLoop);
  const WeightedGraph pair{2, {0}, {1}, {1}}, empty{3, {}, {}, {}};
  history.build(pair);
  EXPECT_EQ(merges(history), (Pairs{{0, 1}}));
  EXPECT_TRUE(history.isolated().empty());
  history.build(empty);
  EXPECT_EQ(history.edges(), 0u);
  EXPECT_EQ(history.isolated().size(), 3u);
}

TEST(ComponentHistory, BadGraphsAreRefused) {
  ComponentHistory history;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const WeightedGraph& bad : {WeightedGraph{2, {0}, {2}, {1}}, {2, {0}, {1}, {-1}}, {2, {0}, {1}, {nan}}})
    EXPECT_THROW(history.build(bad), Error);
}

}  // namespace
}  // namespace jam
