#include "jamscape/observe/energy.hpp"

#include <gtest/gtest.h>

#include "jamscape/observe/box.hpp"
#include "packings.hpp"

namespace jam {
namespace {

TEST(Energy, LedgerHasTheSignsOfTheRecord) {
  EnergyLedger e;
  e.kinetic = 1;
  e.elastic = 2;
  e.damped = 4;
  e.rubbed = 8;
  e.wall_work = 16;
  e.gravity_work = 32;
  EXPECT_EQ(e.sum(), 1 + 2 + 4 + 8 - 16 - 32);
}

TEST(Box, SidesAndVolume) {
  Packing p = test::box(2, {6, 4, 2});
  EXPECT_EQ(box_volume(p), 24);
  EXPECT_EQ(box_measure().evaluate(Snapshot(p, {})).numbers("box_lz")[0], 0);
  p.dimension = 3;
  p.domain.lo = {1, 1, 1};
  EXPECT_EQ(box_volume(p), 5 * 3 * 1);
  EXPECT_EQ(box_measure().evaluate(Snapshot(p, {})).numbers("box_lx")[0], 5);
}

}  // namespace
}  // namespace jam
