// A stiffness the time step cannot carry, and a box too full: the run ends soon, with a reason that is the right one.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "compression.hpp"
#include "jamscape/dem/diverged.hpp"
#include "jamscape/protocol/simulate.hpp"

namespace jam {
namespace {

SystemOptions squeezed(int dimension, WallModel walls, double stiffness) {
  SystemOptions s;
  s.grains.count = dimension == 2 ? 100 : 216;
  s.domain.dimension = dimension;
  s.domain.walls = walls;
  s.domain.area = AreaConvention::actual;
  s.contact.stiffness = stiffness;
  s.start.packing_fraction = dimension == 2 ? 0.6 : 0.4;
  s.stages = {compression("squeeze", dimension == 2 ? 0.86 : 0.66, 1e-3, 3)};
  return s;
}

/// Why a simulation ended before its time; empty if it did not.
std::string verdict(const SystemOptions& s) {
  try {
    simulate(s, {1, "stiff", 0}, {});
  } catch (const Diverged& e) {
    return e.what();
  }
  return "";
}

TEST(TooStiff, the_step_is_named_with_one_that_would_do) {
  for (const double stiffness : {1e6, 1e12, 1e300})
    for (const WallModel walls : {WallModel::beads, WallModel::flat, WallModel::periodic})
      for (const int dimension : {2, 3}) {
        if (dimension == 3 && walls == WallModel::beads) continue;
        const std::string said = verdict(squeezed(dimension, walls, stiffness));
        EXPECT_NE(said.find("time step 0.02 is too long for the stiffness"), std::string::npos)
            << said << " (" << dimension << "D, walls " << static_cast<int>(walls) << ", k " << stiffness << ")";
      }
}

TEST(TooStiff, a_box_too_full_is_no_matter_of_the_step) {
  SystemOptions s = squeezed(2, WallModel::flat, 5);
  s.stages[0].to = 1.9;
  s.stages[0].speed = 1e-2;
  const std::string said = verdict(s);
  EXPECT_NE(said.find("the box is too full"), std::string::npos) << said;
  EXPECT_EQ(said.find("time step"), std::string::npos) << said;
}

TEST(TooStiff, a_stop_is_heard_by_the_clock) {
  SystemOptions s = squeezed(2, WallModel::flat, 5);
  s.stages[0].speed = 1e-6;  // hours
  Hooks hooks;
  const auto begin = std::chrono::steady_clock::now();
  double heard = 0;
  hooks.stop = [&] {
    heard = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return true;
  };
  EXPECT_EQ(simulate(s, {1, "stop", 0}, hooks), Outcome::stopped);
  EXPECT_LT(heard, 30) << "a quarter of a second on an idle machine";
}

}  // namespace
}  // namespace jam
