#include "jamscape/observe/bond_order.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "packings.hpp"

namespace jam {
namespace {

using namespace test;

BondOrder of(const Packing& p) { return bond_order(p, find_bonds(p)); }

// A grain with bonds at these angles (degrees) to grains that touch nothing else.
Packing star(const std::vector<double>& degrees) {
  Packing p = box(2, {20, 20, 0});
  add_grain(p, {10, 10, 0});
  for (const double a : degrees) {
    const double t = a * std::numbers::pi / 180;
    add_grain(p, {10 + std::cos(t), 10 + std::sin(t), 0});
    add_contact(p, 0, static_cast<std::int32_t>(p.grains.size()) - 1, 1);
  }
  return p;
}

TEST(BondOrder, HexagonalLatticeIsOneInEveryWay) {
  const BondOrder b = of(hexagonal(8, 8));
  EXPECT_NEAR(b.printed, 1, 1e-9);
  EXPECT_NEAR(b.closed, 1, 1e-9);
  EXPECT_NEAR(b.local, 1, 1e-9);
  EXPECT_NEAR(b.global, 1, 1e-9);
}

TEST(BondOrder, SquareLatticeIsMinusOneAsPrinted) {
  const BondOrder b = of(square(8, 8));
  EXPECT_NEAR(b.printed, -1, 1e-12);
  EXPECT_NEAR(b.closed, -1, 1e-12);
  EXPECT_NEAR(b.local, 0, 1e-12);
  EXPECT_NEAR(b.global, 0, 1e-12);
}

TEST(BondOrder, StraightChainIsPlusOneAndItsEndsAreZeroAsPrinted) {
  Packing p = box(2, {10, 4, 0});
  for (const double x : {1.0, 2.0, 3.0, 4.0}) add_grain(p, {x, 2, 0});
  touch(p);
  EXPECT_NEAR(of(p).printed, 0.5, 1e-12);
  EXPECT_NEAR(of(p).local, 1, 1e-12);  // one bond has an order of 1
  EXPECT_NEAR(of(p).global, 1, 1e-12);
}

TEST(BondOrder, LeavesTheGapAcrossTheNegativeXAxisOut) {
  // Bonds at -170, -110, -60 (gaps 60, 50) and 230 degrees back round.
  const std::vector<double> angles = {-60, -170, -110};
  const double gap = [](double d) { return std::cos(6 * d * std::numbers::pi / 180); }(50);
  const double around = std::cos(6 * 250 * std::numbers::pi / 180);
  const BondOrder b = of(star(angles));
  EXPECT_NEAR(4 * b.printed, (1 + gap) / 2, 1e-9);
  EXPECT_NEAR(4 * b.closed, (1 + gap + around) / 3, 1e-9);
}

TEST(BondOrder, ABondAlongMinusXIsSortedFirst) {
  // In [-pi, pi) the bond at 180 degrees is at -180: gaps 130 (to -50) and 120 (to 70); 110 is left out.
  const BondOrder b = of(star({180, 70, -50}));
  const auto c = [](double d) { return std::cos(6 * d * std::numbers::pi / 180); };
  EXPECT_NEAR(4 * b.printed, (c(130) + c(120)) / 2, 1e-9);
}

TEST(BondOrder, LocalSeesGrainsThatTheGlobalAverageCancels) {
  // Two hexagonal flowers turned by 30 degrees: phases +1 and -1.
  Packing p = box(2, {40, 20, 0});
  std::int32_t next = 0;
  for (const double turn : {0.0, 30.0}) {
    const double cx = turn == 0 ? 10 : 30;
    add_grain(p, {cx, 10, 0});
    const auto centre = static_cast<std::uint32_t>(next);
    for (int k = 0; k < 6; ++k) {
      const double t = (turn + 60 * k) * std::numbers::pi / 180;
      add_grain(p, {cx + std::cos(t), 10 + std::sin(t), 0});
      add_contact(p, centre, ++next, 1);
    }
    ++next;
  }
  const BondOrder b = of(p);
  EXPECT_NEAR(b.local, 1, 1e-9);
  EXPECT_NEAR(b.global, 0, 1e-9);
  EXPECT_NEAR(b.printed, 2.0 / 14, 1e-9);
}

TEST(BondOrder, IsZeroWithoutBondsAndInThreeDimensions) {
  EXPECT_EQ(of(box(2, {1, 1, 0})).printed, 0);
  EXPECT_EQ(of(ideal_gas(2, {9, 9, 0}, 5, false)).local, 0);
  EXPECT_EQ(of(cloud(3, 60, 2)).printed, 0);
}

}  // namespace
}  // namespace jam
