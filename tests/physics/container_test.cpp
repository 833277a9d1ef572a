// Clusters in a container: starts without overlaps, settling, pressing to a force, resuming, and what is refused.
#include <gtest/gtest.h>

#include <cmath>

#include "jamscape/base/error.hpp"
#include "jamscape/protocol/cluster_start.hpp"
#include "jamscape/protocol/plan.hpp"
#include "jamscape/protocol/simulate.hpp"

namespace jam {
namespace {

const TaskKey key{7, "container", 0};

/// S3's material in units of d_p, 0.125 g and 1 ms.
SystemOptions crosses() {
  SystemOptions s;
  s.grains.count = 60;
  s.grains.shape = BodyShape::cross;
  s.grains.aspect = 3;
  s.grains.sizes = SizeLaw::uniform;
  s.grains.width = 0.3;
  s.domain.walls = WallModel::box;
  s.domain.width = 6;
  s.domain.gravity = 1.962e-3;
  s.contact.law = NormalLaw::ratio;
  s.contact.stiffness = 400;
  s.contact.damping = DampingRule::clipped;
  s.contact.damping_ratio = 0.2;
  s.contact.tangential_stiffness = 0.5;
  s.contact.wall_friction = 0;
  s.integrator.step = 0.005;
  s.start.layout = StartLayout::random;
  s.start.packing_fraction = 0.25;
  StageOptions settle, press, relax;
  settle.name = "settle", settle.kind = StageKind::settle, settle.settle_until = SettleUntil::rest;
  settle.relax.window = 1000, settle.relax.energy = 1e-4;
  press.name = "press", press.kind = StageKind::press, press.speed = 0.05, press.force = 40;
  relax.name = "relax", relax.kind = StageKind::relax;
  relax.relax = {1000, 0, 1e-4, 100};
  s.stages = {settle, press, relax};
  return s;
}

SystemOptions stars(WallModel walls) {
  SystemOptions s = crosses();
  s.domain.dimension = 3;
  s.domain.walls = walls;
  s.domain.width = 4;
  s.domain.thickness = 1.5;
  s.grains.shape = BodyShape::star;
  s.start.packing_fraction = 0.08;
  return s;
}

/// Overlaps of a start, with other bodies and with walls.
std::size_t touching(const SystemOptions& s) {
  ClusterEngine engine(cluster_start(s, key, cluster_room(s, key)));
  engine.compute_forces();
  return engine.record().contacts.size();
}

TEST(ContainerStart, NobodyTouchesAnybody) {
  for (const StartLayout layout : {StartLayout::lattice, StartLayout::random}) {
    SystemOptions flat = crosses(), slab = stars(WallModel::box), tube = stars(WallModel::cylinder);
    for (SystemOptions* s : {&flat, &slab, &tube}) {
      s->start.layout = layout;
      s->start.gap = 0.1;
      EXPECT_EQ(touching(*s), 0u);
    }
  }
}

TEST(ContainerStart, FillsTheHeightItSays) {
  const SystemOptions s = crosses();
  const ClusterRoom room = cluster_room(s, key);
  EXPECT_NEAR(room.container.packing_fraction(room.height), 0.25, 1e-12);
  EXPECT_EQ(room.container.width, 18) << "six lengths of three diameters";
  double area = 0;
  for (const double scale : room.scales) area += room.shape.area * scale * scale;
  EXPECT_DOUBLE_EQ(room.container.bodies, area);
}

TEST(ContainerStart, ASlabIsAsThickAsItsLargestBody) {
  SystemOptions s = stars(WallModel::box);
  s.domain.thickness = 1;
  const ClusterRoom room = cluster_room(s, key);
  double largest = 0;
  for (const double scale : room.scales) largest = std::max(largest, 2 * scale * room.shape.circumradius);
  EXPECT_GT(largest, 3);
  EXPECT_DOUBLE_EQ(room.container.thickness, largest);
}

std::vector<Packing> frames_of(const SystemOptions& s, std::int64_t stop_at = -1) {
  std::vector<Packing> frames;
  Archive saved;
  bool stopped = false;
  std::int64_t step = 0;
  Hooks hooks;
  hooks.look_every = 500;
  hooks.frame = [&](std::size_t, const Packing& p) { frames.push_back(p); };
  hooks.progress = [&](const Progress& p) { step = p.step; };
  hooks.stop = [&] { return stop_at >= 0 && !stopped && step >= stop_at; };
  hooks.checkpoint = [&](const Archive& a) { saved = a, stopped = true; };
  while (simulate(s, key, hooks, stopped ? &saved : nullptr) == Outcome::stopped) {
  }
  return frames;
}

TEST(ContainerRun, SettlesUnderItsWeightAndIsPressedToTheForce) {
  for (const SystemOptions& s : {crosses(), stars(WallModel::cylinder)}) {
    const std::vector<Packing> frames = frames_of(s);
    ASSERT_EQ(frames.size(), 3u);
    const auto floor_force = [](const Packing& p) { return -p.walls[p.walls.size() - 2].force[1]; };
    const auto lid_force = [](const Packing& p) { return p.walls.back().force[1]; };
    double weight = 0;
    for (const double m : frames[0].grains.mass) weight += m * s.domain.gravity;
    EXPECT_NEAR(floor_force(frames[0]) / weight, 1, 0.02) << "at rest the floor carries all, the sides being smooth";
    EXPECT_EQ(lid_force(frames[0]), 0);
    EXPECT_GE(lid_force(frames[1]), 40);
    EXPECT_LT(lid_force(frames[1]), 41) << "watched after every step";
    EXPECT_NEAR(floor_force(frames[2]), lid_force(frames[2]) + weight, 0.05 * lid_force(frames[2]));
    EXPECT_EQ(frames[2].walls.back().position, frames[1].walls.back().position) << "the lid stands";
    EXPECT_GT(frames[1].packing_fraction, frames[0].packing_fraction);
    EXPECT_TRUE(frames[0].relaxation.empty());
    EXPECT_EQ(frames[2].relaxation, s.domain.dimension == 2 ? "energy" : "budget")
        << "a smooth cylinder lets its filling spin";
    for (const Packing& p : frames)
      EXPECT_NEAR(p.energy.sum(), 0, 0.1 * p.energy.turned_over() + 0.5) << "first order in the step";
  }
}

TEST(ContainerRun, StoppedAnywhereItGoesOnWithTheSameBits) {
  const SystemOptions s = crosses();
  const std::vector<Packing> whole = frames_of(s);
  for (const std::int64_t stop : {std::int64_t{1000}, whole[0].step + 700, whole[1].step + 600}) {
    const std::vector<Packing> parts = frames_of(s, stop);
    ASSERT_EQ(parts.size(), whole.size());
    for (std::size_t f = 0; f < whole.size(); ++f) {
      EXPECT_EQ(parts[f].step, whole[f].step);
      EXPECT_EQ(parts[f].grains.position, whole[f].grains.position);
      EXPECT_EQ(parts[f].grains.orientation, whole[f].grains.orientation);
      EXPECT_EQ(parts[f].contacts.normal_force, whole[f].contacts.normal_force);
      EXPECT_EQ(parts[f].walls.back().position, whole[f].walls.back().position);
    }
  }
}

TEST(ContainerPlan, SettlingByTimeIsTheLiteralOne) {
  SystemOptions s = crosses();
  s.stages[0].settle_until = SettleUntil::time;
  const Timetable t = timetable(s, key);
  const double height = cluster_room(s, key).height;
  EXPECT_NEAR(static_cast<double>(t.plan.frames[0].step) * 0.005, 3 * std::sqrt(2 * height / 1.962e-3), 0.005);
  EXPECT_EQ(t.plan.frames[1].step, -1);
  EXPECT_TRUE(std::isnan(t.plan.frames[1].packing_fraction));
  EXPECT_TRUE(t.plan.frames[2].relaxed);
  EXPECT_TRUE(t.plan.frames[1].matches(1234, "press", 0.7, ""));
  EXPECT_FALSE(t.plan.frames[1].matches(1234, "relax", 0.7, "energy"));
}

void expect_refused(const SystemOptions& s, const std::string& part) {
  try {
    timetable(s, key);
    cluster_start(s, key, cluster_room(s, key));
    ADD_FAILURE() << "nothing was wrong; expected: " << part;
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::usage);
    EXPECT_NE((e.problem() + e.suggestion()).find(part), std::string::npos) << e.problem();
  }
}

TEST(ContainerMistakes, SayWhatToDo) {
  SystemOptions s = crosses();
  s.grains.shape = BodyShape::star;
  expect_refused(s, "a star does not lie in a plane");
  s = crosses();
  s.grains.shape = BodyShape::ball;
  expect_refused(s, "grains.shape = \"ball\" is none");
  s = crosses();
  s.stages[1].force = 0;
  expect_refused(s, "stage.press.force");
  s = crosses();
  s.domain.gravity = 0;
  expect_refused(s, "domain.gravity");
  s = crosses();
  s.stages[0].kind = StageKind::compress;
  expect_refused(s, "no stage \"compress\" in a container");
  s = crosses();
  s.domain.width = 1;
  expect_refused(s, "domain.width: the largest body");
  s = crosses();
  s.start.packing_fraction = 0.8;
  expect_refused(s, "no free place");
  s = crosses();
  s.domain.walls = WallModel::cylinder;
  expect_refused(s, "a cylinder is for three dimensions");
  s = crosses();
  s.grains.shape = BodyShape::custom;
  expect_refused(s, "grains.arms has 0 numbers");
  s.grains.arms = {0, 0, 0, 1, 0, 0, 0.5, 1};
  expect_refused(s, "shorter (0.5) than thick (1)");
  s.grains.arms = {0, 0, 0, 1, 0, 0, 3, 1, 9, 0, 0, 1, 0, 0, 3, 1};
  expect_refused(s, "arm");
  s = crosses();
  s.domain.walls = WallModel::flat;
  s.stages = {s.stages[2]};
  s.stages.push_back(crosses().stages[1]);
  expect_refused(s, "no stage \"press\" in a box that shrinks");
}

}  // namespace
}  // namespace jam
