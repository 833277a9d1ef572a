#include "jamscape/observe/bond_blocks.hpp"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "jamscape/base/random.hpp"

namespace jam {
namespace {

using Direction = std::array<double, 2>;

/// Of each grain 0 to 9 directions, some equal, some along an axis.
std::vector<std::vector<Direction>> random_grains() {
  Random random(3, "bond blocks", 0, "angles");
  std::vector<std::vector<Direction>> grains(500);
  for (auto& directions : grains) {
    directions.resize(random.below(10));
    for (Direction& d : directions) {
      const bool coarse = random.uniform() < .3;
      const double angle =
          (coarse ? .5 * static_cast<double>(random.below(5)) : 2 * random.uniform()) * std::numbers::pi;
      d = {std::cos(angle), coarse ? std::round(std::sin(angle)) : std::sin(angle)};
    }
  }
  return grains;
}

double order(double x, double y) {
  const bool lower = y < 0 || (y == 0 && x < 0);
  return lower ? x - 1 : 1 - x;
}

/// One grain by itself: printed, closed, local, re, im.
std::array<double, 5> order_alone(std::vector<Direction> directions) {
  if (directions.empty()) return {};
  std::stable_sort(directions.begin(), directions.end(),
                   [](const auto& a, const auto& b) { return order(a[0], a[1]) < order(b[0], b[1]); });
  std::vector<double> re, im;
  for (const auto& [x, y] : directions) {
    const double re2 = x * x - y * y, im2 = 2 * x * y;
    const double re3 = re2 * x - im2 * y, im3 = re2 * y + im2 * x;
    re.push_back(re3 * re3 - im3 * im3);
    im.push_back(2 * re3 * im3);
  }
  const auto n = static_cast<double>(directions.size());
  double gaps = 0, sum_re = re[0], sum_im = im[0];
  for (std::size_t k = 1; k < re.size(); ++k) {
    gaps += re[k - 1] * re[k] + im[k - 1] * im[k];
    sum_re += re[k];
    sum_im += im[k];
  }
  if (directions.size() == 1) return {0, 0, std::sqrt(re[0] * re[0] + im[0] * im[0]), re[0], im[0]};
  return {gaps / (n - 1), (gaps + (re.back() * re[0] + im.back() * im[0])) / n,
          std::sqrt(sum_re * sum_re + sum_im * sum_im) / n, sum_re / n, sum_im / n};
}

BondBlocks fill(const std::vector<std::vector<Direction>>& grains) {
  std::vector<std::uint32_t> bonds;
  for (const auto& directions : grains) bonds.push_back(static_cast<std::uint32_t>(directions.size()));
  BondBlocks blocks(bonds);
  for (std::size_t k = 0; k < 10; ++k)  // by turns, as contacts come
    for (std::size_t i = 0; i < grains.size(); ++i)
      if (k < grains[i].size()) blocks.add(i, grains[i][k][0], grains[i][k][1]);
  return blocks;
}

TEST(BondBlocks, AllVectorWidthsGiveTheBitsOfOneGrainAfterAnother) {
  const auto grains = random_grains();
  const BondBlocks blocks = fill(grains);
  for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1) {
    hwy::SetSupportedTargetsForTest(left & -left);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    const auto orders = blocks.orders();
    for (std::size_t i = 0; i < grains.size(); ++i) {
      SCOPED_TRACE(i);
      const auto expected = order_alone(grains[i]);
      const LaneOrders& found = orders[blocks.block(i)];
      const std::size_t lane = blocks.lane(i);
      EXPECT_EQ(found.printed[lane], expected[0]);
      EXPECT_EQ(found.closed[lane], expected[1]);
      EXPECT_EQ(found.local[lane], expected[2]);
      EXPECT_EQ(found.re[lane], expected[3]);
      EXPECT_EQ(found.im[lane], expected[4]);
    }
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace
}  // namespace jam
