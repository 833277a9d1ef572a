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
  EXPECT_EQ(relaxed, (std::vector<double>{0.71, 0.75, 0.79, 0.83, 0.87})) << "as far down as start.packing_fraction";
  EXPECT_EQ(t.legs.size(), 2 * n);
  EXPECT_EQ(t.plan.frames.size(), 3 * n);
  EXPECT_GE(t.plan.frames[1].step, 0);
  EXPECT_EQ(t.plan.frames[2].step, -1) << "not known before the relaxation has ended";
}

// The lattice of wide sizes begins below start.packing_fraction, in each realisation elsewhere.
TEST(Frames, lie_on_one_grid_of_exact_decimals_in_all_realisations) {
  for (const WallModel walls : {WallModel::beads, WallModel::flat, WallModel::periodic})
    for (const StageKind kind : {StageKind::compress, StageKind::steps, StageKind::relax}) {
      SystemOptions s = climbing(2);
      s.domain.walls = walls;
      s.start.packing_fraction = 0.64;
      s.grains.width = 1.2;
      StageOptions last = s.stages[0];
      last.kind = kind == StageKind::relax ? StageKind::compress : kind;
      last.to = 0.8;
      last.increment = 0.02;
      last.frames = kind == StageKind::steps ? 0 : 9;
      last.frames_inside = 0;
      s.stages = {last};
      if (kind == StageKind::relax) {
        s.stages.insert(s.stages.begin(), last);
        s.stages[0].name = "rest", s.stages[0].kind = kind, s.stages[0].frames = 0;
      }
      std::vector<double> starts;
      for (std::uint64_t r = 0; r < 4; ++r) {
        const Plan p = plan(s, {1, "grid", r});
        std::vector<double> at;
        for (const PlannedFrame& f : p.frames) at.push_back(f.packing_fraction);
        std::vector<double> grid = {0.66, 0.68, 0.7, 0.72, 0.74, 0.76, 0.78, 0.8};
        if (kind != StageKind::steps) grid.insert(grid.begin(), 0.64);
        if (kind == StageKind::relax) grid.insert(grid.begin(), 0.64);
        EXPECT_EQ(at, grid);
        EXPECT_LT(p.start, 0.64);
        starts.push_back(p.start);
      }
      EXPECT_NE(starts[0], starts[1]);
    }
}

TEST(Frames, below_the_start_asked_for_are_refused_with_a_start_that_would_do) {
  SystemOptions s = climbing(3);
  s.start.packing_fraction = 0.6;
  s.stages[0].to = 0.5;
  try {
    plan(s, {1, "grid", 0});
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(e.suggestion().find("start.packing_fraction = 0."), std::string::npos) << e.suggestion();
  }
  s.stages[0].kind = StageKind::compress;
  s.stages[0].frames_inside = 0;
  const Plan approach = plan(s, {1, "grid", 0});
  ASSERT_EQ(approach.frames.size(), 1u) << "an approach may end below it; a run without frames has its last instant";
  EXPECT_EQ(approach.frames[0].packing_fraction, 0.5);
  EXPECT_EQ(approach.frames[0].step, approach.steps);
}

TEST(Frames, within_one_time_step_are_refused_beforehand) {
  SystemOptions s = climbing(2);
  s.start.packing_fraction = 0.5;
  s.stages[0].kind = StageKind::compress;
  s.stages[0].frames_inside = 0;
  s.stages[0].speed = 0.5;
  s.stages[0].to = 0.6;
  s.stages[0].frames = 100;
  try {
    plan(s, {1, "grid", 0});
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(e.problem().find("stage.climb.frames"), std::string::npos);
    const std::size_t at = e.suggestion().find("frames = ");
    ASSERT_NE(at, std::string::npos);
    s.stages[0].frames = std::stoi(e.suggestion().substr(at + 9));
    EXPECT_GT(s.stages[0].frames, 10);
    EXPECT_NO_THROW(plan(s, {1, "grid", 0})) << e.suggestion();
  }
}

TEST(Frames, of_a_run_that_asks_for_none_is_the_last_instant) {
  SystemOptions s = climbing(2);
  s.start.packing_fraction = 0.5;
  s.stages[0].kind = StageKind::compress;
  s.stages[0].frames_inside = 0;
  s.stages[0].to = 0.7;
  std::vector<Packing> frames;
  Hooks hooks;
  hooks.frame = [&](std::size_t, const Packing& p) { frames.push_back(p); };
  ASSERT_EQ(simulate(s, {2, "none", 0}, hooks), Outcome::finished);
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_NEAR(frames[0].packing_fraction, 0.7, 1e-3);
}

TEST(Frames, of_a_periodic_box_that_becomes_too_narrow_are_refused_with_the_number_that_would_do) {
  SystemOptions s = climbing(2);
  s.domain.walls = WallModel::periodic;
  s.start.packing_fraction = 0.5;
  s.grains.count = 9;
  try {
    plan(s, {1, "grid", 0});
    FAIL();
  } catch (const Error& e) {
    const std::size_t at = e.suggestion().find("grains.count = ");
    ASSERT_NE(at, std::string::npos);
    s.grains.count = std::stoi(e.suggestion().substr(at + 15));
    EXPECT_LT(s.grains.count, 30);
    Hooks hooks;
    hooks.largest_ledger_error = 1;
    EXPECT_EQ(simulate(s, {1, "grid", 0}, hooks), Outcome::finished);
  }
}

TEST(Relaxation, rest_by_the_kinetic_energy_is_judged_by_the_forces_too) {
  Relaxation r({.window = 1500, .fluctuation = 0.1, .energy = 0, .windows = 10, .unbalanced = 0.01});
  int asked = 0;
  for (int k = 0; k < 400 && r.ended().empty(); ++k) {
    r.add_sample(1, 1);
    if (!r.wants_forces()) continue;
    EXPECT_TRUE(r.ended().empty());
    r.judge_forces(++asked < 4 ? 0.5 : 0.009);
  }
  EXPECT_EQ(asked, 4);
  EXPECT_EQ(r.ended(), relaxed_fluctuation);
  Relaxation never({.window = 1500, .fluctuation = 0.1, .energy = 0, .windows = 2, .unbalanced = 0.01});
  while (never.ended().empty()) {
    never.add_sample(1, 1);
    if (never.wants_forces()) never.judge_forces(1);
  }
  EXPECT_EQ(never.ended(), not_relaxed);
}

// Kept, the drift of the start was 99.99 % of the kinetic energy in the end.
TEST(Relaxation, a_periodic_box_has_no_drift_and_comes_to_rest) {
  for (const int dimension : {2, 3}) {
    SystemOptions s = climbing(dimension);
    s.domain.walls = WallModel::periodic;
    s.stages[0].frames_inside = 0;
    s.stages[0].to = s.start.packing_fraction = dimension == 2 ? 0.7 : 0.5;
    s.stages[0].kind = StageKind::compress;
    StageOptions rise = s.stages[0];
    rise.name = "rise", rise.to = dimension == 2 ? 0.88 : 0.68;
    StageOptions rest = s.stages[0];
    rest.name = "rest", rest.kind = StageKind::relax;
    rest.relax = {.window = 5000, .fluctuation = 0, .energy = 1e-6, .windows = 40};
    s.stages.push_back(rise), s.stages.push_back(rest);
    Packing end;
    Hooks hooks;
    hooks.frame = [&](std::size_t, const Packing& p) { end = p; };
    ASSERT_EQ(simulate(s, {3, "drift", 0}, hooks), Outcome::finished);
    EXPECT_EQ(end.relaxation, relaxed_energy) << dimension;
    Vec3 momentum{};
    double mass = 0;
    for (std::size_t k = 0; k < end.grains.size(); ++k)
      momentum += end.grains.mass[k] * end.grains.velocity[k], mass += end.grains.mass[k];
    EXPECT_LT(norm(momentum) / mass, 1e-12);
  }
}

TEST(Relaxation, gravity_is_refused_where_grains_would_fall_for_ever) {
  SystemOptions s = climbing(2);
  s.domain.gravity = 1e-3;
  EXPECT_NO_THROW(check_start(s)) << "flat walls";
  s.domain.walls = WallModel::periodic;
  EXPECT_THROW(check_start(s), Error);
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
