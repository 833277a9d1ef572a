#include "jamscape/base/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace jam {
namespace {

// Known answers published with Random123 (kat_vectors).
TEST(Philox, KnownAnswers) {
  using Words = std::array<std::uint32_t, 4>;
  EXPECT_EQ(philox4x32({0, 0, 0, 0}, {0, 0}), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox4x32({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
            (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox4x32({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(HashName, IsFnv1a) {
  EXPECT_EQ(hash_name(""), 0xcbf29ce484222325u);
  EXPECT_EQ(hash_name("a"), 0xaf63dc4c8601ec8cu);
  EXPECT_EQ(hash_name("foobar"), 0x85944171f73967e8u);
}

TEST(Random, StreamsDifferInEveryPartOfTheirName) {
  std::set<std::uint64_t> first;
  for (const std::uint64_t seed : {1u, 2u})
    for (const char* system : {"a", "b"})
      for (const std::uint64_t realisation : {0u, 1u})
        for (const char* purpose : {"sizes", "velocities"})
          first.insert(Random(seed, system, realisation, purpose).bits());
  EXPECT_EQ(first.size(), 16u);
}

TEST(Random, TheSameNameGivesTheSameNumbers) {
  Random a(7, "s", 3, "p"), b(7, "s", 3, "p");
  for (int k = 0; k < 100; ++k) ASSERT_EQ(a.bits(), b.bits());
}

TEST(Random, UniformHasItsMoments) {
  Random r(1, "s", 0, "p");
  double sum = 0, squares = 0;
  constexpr int n = 100000;
  for (int k = 0; k < n; ++k) {
    const double u = r.uniform();
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    sum += u, squares += u * u;
  }
  EXPECT_NEAR(sum / n, 0.5, 5 * std::sqrt(1.0 / 12 / n));
  EXPECT_NEAR(squares / n, 1.0 / 3, 5 * std::sqrt(4.0 / 45 / n));
}

TEST(Random, BelowReachesEveryValueEvenly) {
  Random r(1, "s", 0, "p");
  int count[7] = {};
  for (int k = 0; k < 70000; ++k) ++count[r.below(7)];
  for (const int c : count) EXPECT_NEAR(c, 10000, 500);
}

}  // namespace
}  // namespace jam
