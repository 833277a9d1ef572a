#include "jamscape/network/union_find.hpp"

#include <gtest/gtest.h>

namespace jam {
namespace {

TEST(UnionFind, smallest_member_leads) {
  UnionFind sets(6);
  EXPECT_EQ(sets.find(5), 5u);
  auto merge = sets.unite(5, 3);
  EXPECT_TRUE(merge.joined());
  EXPECT_EQ(merge.kept, 3u);
  EXPECT_EQ(merge.lost, 5u);
  merge = sets.unite(5, 1);
  EXPECT_EQ(merge.kept, 1u);
  EXPECT_EQ(merge.lost, 3u);
  EXPECT_EQ(sets.find(5), 1u);
  EXPECT_FALSE(sets.unite(3, 1).joined());
  EXPECT_EQ(sets.find(0), 0u);
}

TEST(UnionFind, long_chains_end_at_the_first) {
  constexpr std::uint32_t n = 100000;
  UnionFind sets(n);
  for (std::uint32_t i = n - 1; i > 0; --i) EXPECT_EQ(sets.unite(i, i - 1).lost, i);
  for (std::uint32_t i = 0; i < n; ++i) EXPECT_EQ(sets.find(i), 0u);
  sets.reset(3);
  EXPECT_EQ(sets.find(2), 2u);
}

}  // namespace
}  // namespace jam
