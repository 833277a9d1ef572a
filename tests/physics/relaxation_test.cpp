// Stages that relax: when they end, what they leave, and that they resume to the bit.
#include "jamscape/protocol/relaxation.hpp"

#include <gtest/gtest.h>

#include "jamscape/base/error.hpp"
#include "jamscape/protocol/plan.hpp"
#include "jamscape/protocol/start.hpp"
#include "two_bodies.hpp"

namespace jam {
namespace {

std::string end_of(const RelaxOptions& options, const std::function<double(std::int64_t)>& kinetic, double elastic,
                   std::int64_t* step = nullptr) {
  Relaxation r(options);
  for (int k = 0; k < 100000 && r.ended().empty(); ++k) {
    if (step) *step = r.next_sample();
    r.add_sample(kinetic(r.next_sample()), elastic);
  }
  return r.ended();
}

TEST(Relaxation, ends_for_the_first_of_three_reasons) {
  const RelaxOptions o{1500, 0.1, 1e-10, 10};  // a sample every 10 steps
  std::int64_t step = 0;
  EXPECT_EQ(end_of(
                o, [](std::int64_t) { return 1.0; }, 1.0, &step),
            relaxed_fluctuation);
  EXPECT_EQ(step, 1500) << "constant from the start: after one window";
  EXPECT_EQ(end_of(
                o, [](std::int64_t k) { return std::exp(-0.1 * static_cast<double>(k)); }, 1.0, &step),
            relaxed_energy);
  EXPECT_NEAR(static_cast<double>(step), 230, 100) << "e^-23 = 1e-10; the elastic energy is looked at every 100 steps";
  EXPECT_EQ(end_of(
                o, [](std::int64_t k) { return 1.5 + (k % 1000 < 500 ? 1.0 : -1.0); }, 1.0, &step),
            not_relaxed);
  EXPECT_EQ(step, 15000 + 10);
  EXPECT_EQ(end_of(
                o, [](std::int64_t) { return 0.0; }, 0.0, &step),
            relaxed_energy)
      << "everything at rest";
}

// A dilute gas cools as t^-2; then std/mean over a window falls below a tenth after some 5.5 windows (theory 1, note
// g).
TEST(Relaxation, a_cooling_gas_meets_the_criterion_after_five_windows_and_a_half) {
  const RelaxOptions o{15000, 0.1, 1e-10, 20};
  std::int64_t step = 0;
  const auto haff = [](std::int64_t k) { return 1 / std::pow(1 + static_cast<double>(k) / 300.0, 2); };
  EXPECT_EQ(end_of(o, haff, 0.0, &step), relaxed_fluctuation);
  EXPECT_NEAR(static_cast<double>(step) / 15000, 6.3, 0.5) << "measured at the end of the window";
}

SystemOptions climbing(int dimension) {
  SystemOptions s;
  s.grains.count = dimension == 2 ? 100 : 125;
  s.domain.dimension = dimension;
  s.domain.walls = WallModel::flat;
  s.start.packing_fraction = dimension == 2 ? 0.7 : 0.5;
  StageOptions climb;
  climb.name = "climb";
  climb.kind = StageKind::steps;
  climb.to = dimension == 2 ? 0.87 : 0.66;
  climb.increment = 0.04;
  climb.speed = 5e-3;
  climb.frames_inside = 2;
  climb.relax.window = 1500;
  climb.relax.windows = 3;
  s.stages = {climb};
  return s;
}

// A packing that swings as a whole has no kinetic energy at its turning points.
TEST(Relaxation, an_average_does_not_take_a_turning_point_for_rest) {
  const auto samples_to_the_end = [](double average) {
    Relaxation r({.window = 1500, .fluctuation = 0, .energy = 1e-3, .windows = 40, .energy_average = average});
    int n = 0;
    for (; r.ended().empty(); ++n) {
      const double swing = std::sin(0.1 * (n + 1)) * std::exp(-1e-3 * n);
      r.add_sample(swing * swing, 1);
    }
    return std::pair(n, r.ended());
  };
  const auto [one, why_one] = samples_to_the_end(0);
  const auto [mean, why_mean] = samples_to_the_end(0.25);
  EXPECT_EQ(why_one, relaxed_energy);
  EXPECT_EQ(why_mean, relaxed_energy);
  EXPECT_LT(one, 1000) << "at a turning point";
  EXPECT_GT(mean, 2800) << "where exp(-2e-3 n)/2 is a thousandth: n = 3107";
  EXPECT_LT(mean, 3400);
}

TEST(Steps, stand_on_a_grid_that_ends_at_the_last_packing_fraction) {
  const Timetable t = timetable(climbing(2), {1, "grid", 0});
  std::vector<double> relaxed;
  for (const PlannedFrame& f : t.plan.frames)
    if (f.relaxed) relaxed.push_back(f.packing_fraction);
  const std::size_t n = relaxed.size();
  ASSERT_GE(n, 5u);  // ..., .79, .83, .87, as far down as the box begins
  for (std::size_t k = 0; k < n; ++k) EXPECT_NEAR(relaxed[n - 1 - k], 0.87 - 0.04 * static_cast<double>(k), 1e-9);
  const StartBox box = start_box(climbing(2), draw_diameters(climbing(2).grains, {1, "grid", 0}));
  EXPECT_LT(relaxed[0] - 0.04, box.measure.packing_fraction(box.length));
  EXPECT_EQ(t.legs.size(), 2 * n);
  EXPECT_EQ(t.plan.frames.size(), 3 * n);
  EXPECT_GE(t.plan.frames[1].step, 0);
  EXPECT_EQ(t.plan.frames[2].step, -1) << "not known before the relaxation has ended";
}

TEST(Steps, relaxed_frames_stand_still_and_say_how_they_got_there) {
  for (const int dimension : {2, 3}) {
    SystemOptions s = climbing(dimension);
    s.stages[0].relax.window = 6000;
    std::vector<Packing> frames;
    Hooks hooks;
    hooks.frame = [&](std::size_t, const Packing& p) { frames.push_back(p); };
    ASSERT_EQ(simulate(s, {2, "still", 0}, hooks), Outcome::finished);
    const Plan planned = plan(s, {2, "still", 0});
    ASSERT_EQ(frames.size(), planned.frames.size());
    for (std::size_t k = 0; k < frames.size(); ++k) {
      const Packing& p = frames[k];
      EXPECT_TRUE(planned.frames[k].matches(p.step, p.stage, p.packing_fraction, p.relaxation)) << k;
      EXPECT_EQ(p.relaxation.empty(), !planned.frames[k].relaxed);
      if (p.relaxation.empty()) continue;
      EXPECT_EQ(norm(p.walls[0].velocity), 0);
      EXPECT_LT(p.energy.kinetic, 0.2 * frames[k - 1].energy.kinetic) << "at rest, or nearly, after the walls stopped";
    }
  }
}

TEST(Steps, a_run_stopped_within_relaxations_gives_the_bits_of_one_never_stopped) {
  const SystemOptions s = climbing(2);
  const TaskKey key{3, "stop", 0};
  std::vector<double> whole, pieces;
  const auto note = [](std::vector<double>& to) {
    return [&to](std::size_t, const Packing& p) {
      to.push_back(static_cast<double>(p.step));
      for (const Vec3& x : p.grains.position) to.insert(to.end(), x.c, x.c + 3);
      for (const double f : p.contacts.normal_force) to.push_back(f);
      to.push_back(p.energy.sum());
    };
  };
  Hooks hooks;
  hooks.frame = note(whole);
  ASSERT_EQ(simulate(s, key, hooks), Outcome::finished);
  Archive saved;
  hooks.frame = note(pieces);
  hooks.look_every = 777;
  hooks.stop = [] { return true; };
  hooks.checkpoint = [&](const Archive& a) { saved = a; };
  Outcome outcome = simulate(s, key, hooks);
  int stops = 0;
  for (; outcome == Outcome::stopped; ++stops) outcome = simulate(s, key, hooks, &saved);
  EXPECT_GT(stops, 10);
  EXPECT_EQ(whole, pieces);
}

TEST(Steps, frames_asked_for_inside_change_no_bit_of_the_relaxed_ones) {
  const auto relaxed = [](std::int64_t inside) {
    SystemOptions s = climbing(2);
    s.stages[0].frames_inside = inside;
    std::vector<double> out;
    Hooks hooks;
    hooks.frame = [&](std::size_t, const Packing& p) {
      if (!p.relaxation.empty()) out.push_back(static_cast<double>(p.step)), out.push_back(p.energy.elastic);
    };
    simulate(s, {4, "inside", 0}, hooks);
    return out;
  };
  EXPECT_EQ(relaxed(0), relaxed(3));
}

TEST(Steps, frames_of_another_kind_of_stage_are_refused) {
  SystemOptions s = climbing(2);
  s.stages[0].frames = 5;
  EXPECT_THROW(plan(s, {1, "x", 0}), Error);
}

}  // namespace
}  // namespace jam
