#include "jamscape/topology/bins.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "networks.hpp"

namespace jam {

std::ostream& operator<<(std::ostream& out, const BinCounts& c) {
  return out << "rough " << c.rough << " strong " << c.strong << " medium " << c.medium << " weak " << c.weak;
}

namespace {

PersistencePair point(double birth, double death, int dimension = 0) { return {dimension, birth, death, false, 0, 0}; }
PersistencePair essential(double birth, int dimension = 0) { return {dimension, birth, 0, true, 0, -1}; }

BinCounts count(const PersistencePair& p, const BinOptions& options = {}) {
  return persistence_bins({{p}, {}}, p.dimension, options);
}

constexpr BinCounts kRough{.rough = 1}, kStrong{.strong = 1}, kMedium{.medium = 1}, kWeak{.weak = 1}, kNone{};

TEST(Bins, by_birth_and_lifetime) {
  EXPECT_EQ(count(point(3, 1)), kStrong);
  EXPECT_EQ(count(point(2, 1)), kMedium);
  EXPECT_EQ(count(point(.5, .25)), kWeak);
  EXPECT_EQ(count(point(3, 2.95)), kRough);
  EXPECT_EQ(count(point(2, 1.95)), kRough);
  EXPECT_EQ(count(point(.5, .45)), kRough);
}

TEST(Bins, borders_belong_to_the_stronger_bin) {
  EXPECT_EQ(count(point(2.5, 1)), kStrong);
  EXPECT_EQ(count(point(1, .5)), kMedium);
  const BinOptions exact{.rough = .125};  // so that a lifetime of exactly `rough` exists
  EXPECT_EQ(count(point(3, 2.875), exact), kStrong);
  EXPECT_EQ(count(point(.5, .375), exact), kWeak);
}

TEST(Bins, of_the_second_study_call_a_lifetime_at_the_border_rough) {
  const BinOptions closed{.rough = .125, .edge = RoughEdge::closed};
  EXPECT_EQ(count(point(3, 2.875), closed), kRough);
  EXPECT_EQ(count(point(3, 2.75), closed), kStrong);
}

// Tenths of forces, whose lifetimes are 0.10000000000000009 and 0.09999999999999998 in a computer.
TEST(Bins, a_decimal_lifetime_on_the_border_is_on_it_however_it_is_rounded) {
  const BinOptions closed{.edge = RoughEdge::closed};
  for (const auto& p : {point(1.1, 1.0), point(1.1 / 1.0, 11. / 11), point(3, 2.9), point(1.3, 1.2)}) {
    EXPECT_EQ(count(p, closed), kRough) << p.birth;
    EXPECT_NE(count(p), kRough) << p.birth;
  }
  EXPECT_EQ(count(point(.5, .4)), kWeak);
  EXPECT_EQ(count(point(.5, .4), closed), kRough);
}

TEST(Bins, births_on_a_border_to_within_round_off_belong_to_the_stronger_bin) {
  EXPECT_EQ(count(point(2.5 * (1 - 2e-16), 0)), kStrong);
  EXPECT_EQ(count(point(.7 + .2 + .1, 0)), kMedium);  // .9999999999999999
  EXPECT_EQ(count(point(1 - 1e-9, 0)), kWeak);
}

TEST(Bins, a_lifetime_of_round_off_is_none) {
  EXPECT_EQ(count(point(1, .7 + .2 + .1)), kNone);
  EXPECT_EQ(count(point(1, 1 - 1e-9)), kRough);
}

TEST(Bins, essential_classes_die_at_zero) {
  EXPECT_EQ(count(essential(4)), kStrong);
  EXPECT_EQ(count(essential(1.5, 1)), kMedium);
  EXPECT_EQ(count(essential(.1, 1)), kWeak);
  EXPECT_EQ(count(essential(.05, 1)), kRough);
}

TEST(Bins, of_zero_length_only_isolated_vertices_count) {
  EXPECT_EQ(count(essential(0)), kRough);
  EXPECT_EQ(count(point(2, 2)), kNone);
  EXPECT_EQ(count(point(0, 0)), kNone);
  EXPECT_EQ(count(essential(0, 1)), kNone);
}

TEST(Bins, part_the_diagram_of_a_network) {
  const auto g = examples::clamped(examples::shuffled(examples::packing(400, 2, .84, 100, 3), 30, 1), 5);
  const auto plain = persistence(g), with_zero = persistence(g, {.keep_zero_length = true});
  for (const int k : {0, 1}) {
    const auto bins = persistence_bins(plain, k);
    EXPECT_EQ(static_cast<std::ptrdiff_t>(bins.total()),
              std::count_if(plain.pairs.begin(), plain.pairs.end(), [&](const auto& p) { return p.dimension == k; }));
    EXPECT_EQ(persistence_bins(with_zero, k), bins);
    EXPECT_GT(bins.rough * bins.medium * bins.weak, 0u);
  }
}

TEST(Bins, of_a_gas_are_all_rough) {
  EXPECT_EQ(persistence_bins(persistence(WeightedGraph{500, {}, {}, {}}), 0), BinCounts{.rough = 500});
}

}  // namespace
}  // namespace jam
