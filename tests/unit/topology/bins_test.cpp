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
