#include "jamscape/dem/parts.hpp"

#include <gtest/gtest.h>

#include <set>

namespace jam {
namespace {

TEST(Parts, a_small_packing_is_one_part_with_all_its_beads) {
  for (const std::size_t grains : {0u, 1u, 2000u, 19999u}) {
    const Parts parts(2, grains, 300);
    EXPECT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts.with_grains(), 1u);
    EXPECT_EQ(parts.grains(0).end, grains);
    ASSERT_EQ(parts.stretches(), 1u);
    EXPECT_EQ(parts.stretches_of(0).end, 1u);
    EXPECT_EQ(parts.bodies_of_stretch(0).begin, 0u);
    EXPECT_EQ(parts.bodies_of_stretch(0).end, grains + 300);
    EXPECT_EQ(parts.stretch(0).end, grains);
    EXPECT_EQ(parts.of(grains + 299), 0u);
  }
}

TEST(Parts, every_body_of_a_large_packing_is_in_one_part) {
  for (const int dimension : {2, 3})
    for (const std::size_t grains : {20000u, 20001u, 65537u, 100000u, 1000003u}) {
      const std::size_t beads = 1000;
      const Parts parts(dimension, grains, beads);
      ASSERT_GE(parts.with_grains(), 2u);
      EXPECT_EQ(parts.size(), parts.with_grains() + 4);  // 1000 beads, 256 a part
      std::size_t next = 0, stretch = 0;
      for (std::size_t p = 0; p < parts.with_grains(); ++p) {
        const auto [begin, end] = parts.grains(p);
        EXPECT_EQ(begin, next);
        EXPECT_EQ(begin % Parts::widest_tile, 0u);
        ASSERT_LT(begin, end);
        EXPECT_LE(end - begin, Parts::most_grains(dimension));
        EXPECT_EQ(parts.of(begin), p);
        EXPECT_EQ(parts.of(end - 1), p);
        ASSERT_EQ(parts.stretches_of(p).begin, stretch);
        for (std::size_t from = begin; from < end; from = parts.stretch(stretch++).end) {
          EXPECT_EQ(parts.stretch(stretch).begin, from);
          EXPECT_EQ(parts.stretch_of(from), stretch);
          EXPECT_LE(parts.stretch(stretch).end, end);
          EXPECT_EQ(parts.bodies_of_stretch(stretch).begin, from);
          EXPECT_EQ(parts.bodies_of_stretch(stretch).end,
                    stretch + 1 == parts.stretches() ? grains + beads : parts.stretch(stretch).end);
        }
        ASSERT_EQ(parts.stretches_of(p).end, stretch);
        next = end;
      }
      EXPECT_EQ(next, grains);
      EXPECT_EQ(stretch, parts.stretches());
      EXPECT_EQ(parts.of(grains), parts.with_grains());
      EXPECT_EQ(parts.of(grains + beads - 1), parts.size() - 1);
    }
}

/// Rounds of the neighbours; fails where a part is twice in one.
std::size_t count_rounds(const std::vector<Neighbours>& neighbours, std::size_t parts) {
  const auto rounds = deal_rounds(neighbours, parts);
  EXPECT_EQ(rounds.size(), neighbours.size());
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
  std::set<std::uint32_t> used;
  for (std::size_t k = 0; k < rounds.size(); ++k) {
    EXPECT_TRUE(seen.insert({rounds[k], neighbours[k].a}).second);
    EXPECT_TRUE(seen.insert({rounds[k], neighbours[k].b}).second);
    used.insert(rounds[k]);
  }
  EXPECT_TRUE(used.empty() || *used.rbegin() + 1 == used.size()) << "a round is empty";
  return used.size();
}

TEST(Rounds, no_part_is_twice_in_one) {
  EXPECT_EQ(count_rounds({}, 5), 0u);
  EXPECT_EQ(count_rounds({{0, 1, 7}}, 2), 1u);
  EXPECT_EQ(count_rounds({{0, 1, 7}, {2, 3, 1}}, 4), 1u);
  EXPECT_EQ(count_rounds({{0, 1, 7}, {0, 2, 1}, {0, 3, 1}}, 4), 3u);  // all share part 0
  std::vector<Neighbours> grid;                                       // 8 x 8 parts with 4 neighbours each
  for (std::uint32_t y = 0; y < 8; ++y)
    for (std::uint32_t x = 0; x < 8; ++x) {
      if (x < 7) grid.push_back({8 * y + x, 8 * y + x + 1, 10 + (x * 7 + y) % 5});
      if (y < 7) grid.push_back({8 * y + x, 8 * y + x + 8, 10 + (x + y * 3) % 5});
    }
  EXPECT_LE(count_rounds(grid, 64), 7u);  // greedy: at most 2 * 4 - 1
}

TEST(Rounds, the_ones_with_most_pairs_come_first) {
  EXPECT_EQ(deal_rounds(std::vector<Neighbours>{{0, 1, 3}, {0, 2, 9}, {1, 2, 5}}, 3),
            (std::vector<std::uint32_t>{2, 0, 1}));
}

}  // namespace
}  // namespace jam
