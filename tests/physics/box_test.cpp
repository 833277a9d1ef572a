// Packing fractions, start lattices and timetables.
#include <gtest/gtest.h>

#include "compression.hpp"
#include "jamscape/base/error.hpp"
#include "jamscape/protocol/plan.hpp"
#include "jamscape/protocol/start.hpp"

namespace jam {
namespace {

TEST(Box, length_inverts_packing_fraction_in_every_convention) {
  for (const BoxConvention c : {BoxConvention::half_beads, BoxConvention::bead_centre, BoxConvention::inner_tangent}) {
    const BoxMeasure box{2, WallModel::beads, c, 1500, 1520};
    for (const double rho : {0.5, 0.6, 0.9}) EXPECT_NEAR(box.packing_fraction(box.length(rho)), rho, 1e-14);
  }
  const BoxMeasure cube{3, WallModel::flat, BoxConvention::half_beads, 900, 900};
  EXPECT_NEAR(cube.packing_fraction(cube.length(0.57)), 0.57, 1e-14);
  // S1 between its two packing fractions: the walls travel about 4.7 d (theory sec. 7)
  const BoxMeasure s1{2, WallModel::beads, BoxConvention::half_beads, 2025 * std::numbers::pi / 4, 0};
  EXPECT_NEAR((s1.length(0.6) - s1.length(0.9)) / 2, 4.7, 0.05);
}

TEST(Start, sizes_follow_their_distribution) {
  GrainOptions o;
  o.count = 100000;
  const auto d = draw_diameters(o, {1, "sizes", 0});
  double mean = 0, least = 9, most = 0;
  for (const double a : d) mean += a / 1e5, least = std::min(least, a), most = std::max(most, a);
  EXPECT_NEAR(mean, 1, 3 * 0.4 / std::sqrt(12.0 * 1e5));
  EXPECT_GT(least, 0.8);
  EXPECT_LT(most, 1.2);
  EXPECT_NEAR(mean_power(o, 2), 1 + 0.4 * 0.4 / 12, 1e-14);
  o.sizes = SizeLaw::bidisperse;
  EXPECT_NEAR(mean_power(o, 1), 1, 1e-14);
  EXPECT_NEAR(mean_power(o, 2), 1.02768, 1e-5);  // theory sec. 1
  EXPECT_NEAR(mean_power(o, 3), 1.08630, 1e-5);
}

TEST(Start, no_grain_touches_anything_and_the_mean_mass_is_one) {
  SystemOptions s;
  for (const WallModel walls : {WallModel::beads, WallModel::flat, WallModel::periodic})
    for (const double width : {0.0, 0.4}) {
      s.domain.walls = walls;
      s.grains.width = width;
      const auto setup = start<2>(s, {1, "start", 0});
      Engine<2> engine(setup);
      engine.compute_forces();
      EXPECT_EQ(engine.record().contacts.size(), 0u);
      double mass = 0;
      for (const double m : setup.mass) mass += m / static_cast<double>(setup.mass.size());
      EXPECT_NEAR(mass, 1, 0.01);
    }
}

TEST(Timetable, frames_lie_on_the_packing_fractions_asked_for) {
  SystemOptions s;
  s.grains.count = 100;
  s.stages = {compression("approach", 0.6, 1e-2, 0), compression("compress", 0.7, 1e-2, 5, {0.62, 0.65})};
  const Timetable t = timetable(s, {1, "plan", 0});
  ASSERT_EQ(t.plan.frames.size(), 6u);  // .65 is asked for twice
  EXPECT_NEAR(t.plan.frames[0].packing_fraction, 0.6, 1e-12);
  EXPECT_NEAR(t.plan.frames[1].packing_fraction, 0.62, 1e-12);
  EXPECT_EQ(t.plan.frames.back().step, t.plan.steps);
  Hooks hooks;
  std::size_t seen = 0;
  hooks.frame = [&](std::size_t k, const Packing& p) {
    EXPECT_EQ(k, seen++);
    EXPECT_EQ(p.step, t.plan.frames[k].step);
    EXPECT_NEAR(p.packing_fraction, t.plan.frames[k].packing_fraction, 5e-5);
    EXPECT_GE(p.packing_fraction, t.plan.frames[k].packing_fraction - 1e-9);
  };
  EXPECT_EQ(simulate(s, {1, "plan", 0}, hooks), Outcome::finished);
  EXPECT_EQ(seen, 6u);
}

TEST(Timetable, refuses_what_cannot_be) {
  SystemOptions s;
  EXPECT_THROW(timetable(s, {}), Error);  // no stage
  s.stages = {compression("down", 0.3, 1e-3, 0)};
  EXPECT_THROW(timetable(s, {}), Error);
  s.stages = {compression("up", 0.8, 1e-3, 0, {0.85})};
  EXPECT_THROW(timetable(s, {}), Error);
  s.domain.dimension = 3;
  EXPECT_THROW(start<3>(s, {}), Error);
}

}  // namespace
}  // namespace jam
