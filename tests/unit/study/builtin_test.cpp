#include "jamscape/study/builtin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "jamscape/study/identity.hpp"
#include "jamscape/study/study.hpp"
#include "jamscape/study/task.hpp"

namespace jam {
namespace {

TEST(BuiltinStudies, AreThereAndCanBe) {
  const std::vector<std::string_view> names = builtin_studies();
  for (const char* name : {"quickstart", "kramar2013", "kramar2013-mu0-rp0", "kramar2013-mu0.5-rp0.4"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  for (const std::string_view name : names) {
    const std::string file = std::string(name) + ".toml";
    const Study study = read_study_text(builtin_file(file), file);
    EXPECT_EQ(study.info.name, name);
    EXPECT_FALSE(study.info.title.empty()) << name;
    EXPECT_FALSE(plan_tasks(study).empty()) << name;
  }
}

// S1 Sec. II.A, App. A: what the study must be to be called that.
TEST(BuiltinStudies, Kramar2013IsThePapersSystem) {
  const Study s = read_study_text(builtin_file("kramar2013.toml"), "kramar2013.toml");
  ASSERT_EQ(s.systems.size(), 6u);
  EXPECT_EQ(s.info.realisations, 20);
  for (const System& system : s.systems) {
    EXPECT_EQ(system.options.grains.count, 45 * 45);
    EXPECT_EQ(system.options.integrator.scheme, Scheme::gear5);
    EXPECT_EQ(system.options.integrator.step, 0.02);
    EXPECT_EQ(system.options.stages.back().speed, 2.5e-5);
    EXPECT_EQ(system.options.stages.back().to, 0.9);
    EXPECT_EQ(system.options.contact.restitution, 0.5);
    EXPECT_EQ(system.options.domain.walls, WallModel::beads);
  }
  const std::vector<Task> tasks = plan_tasks(s);
  EXPECT_EQ(tasks.size(), 120u);
  EXPECT_EQ(tasks.front().plan.frames.size(), 112u) << "100 frames and the multiples of .02";
}

TEST(BuiltinStudies, TheVariantsShareTheirRunsWithTheWhole) {
  const Study whole = read_study_text(builtin_file("kramar2013.toml"), "whole");
  const std::vector<Task> all = plan_tasks(whole);
  for (const System& system : whole.systems) {
    const std::string file = "kramar2013-" + system.name + ".toml";
    const Study one = read_study_text(builtin_file(file), file);
    const std::string hash = plan_tasks(one).front().hash;
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Task& t) { return t.hash == hash; })) << file;
  }
}

// S2 Sec. 2 and 3; scaled numbers from the table of theory sec. 2.2.
TEST(BuiltinStudies, NetworksAreThePapersThreeSystems) {
  const Study s = read_study_text(builtin_file("networks-2d-3d.toml"), "networks-2d-3d.toml");
  ASSERT_EQ(s.systems.size(), 3u);
  EXPECT_EQ(s.info.realisations, 20);
  EXPECT_EQ(s.info.targets, "networks-2d-3d");
  const double to[] = {0.890, 0.906, 0.710}, stiffness[] = {4.9348, 485.65, 485.65}, v0[] = {3.69e-5, 3.66e-4, 3.66e-4};
  const double box[] = {50, 50, 20}, d_small = 0.88235, d_large = 1.23529;
  for (std::size_t k = 0; k < 3; ++k) {
    const SystemOptions& o = s.systems[k].options;
    EXPECT_EQ(o.domain.dimension, k == 2 ? 3 : 2);
    EXPECT_EQ(o.grains.count, k == 2 ? 4000 : 2000);
    EXPECT_EQ(o.contact.law, k == 0 ? NormalLaw::linear : NormalLaw::hertz);
    EXPECT_NEAR(o.contact.stiffness, stiffness[k], 1e-4 * stiffness[k]);
    EXPECT_NEAR(o.contact.impact_speed, v0[k], 2e-3 * v0[k]);
    EXPECT_NEAR(o.contact.tangential_stiffness, 6.0 / 7, 1e-15);
    EXPECT_EQ(o.contact.friction, 0.5);
    EXPECT_EQ(o.contact.restitution, 0.5);
    EXPECT_EQ(o.contact.damping, DampingRule::clipped);
    EXPECT_EQ(o.domain.walls, WallModel::flat);
    ASSERT_EQ(o.stages.size(), 2u);
    const StageOptions& steps = o.stages[1];
    EXPECT_EQ(steps.kind, StageKind::steps);
    EXPECT_EQ(steps.increment, 0.02);
    EXPECT_EQ(steps.speed, o.contact.impact_speed) << "the walls move at v0";
    EXPECT_EQ(steps.to, to[k]);
    const double area = k == 2 ? M_PI / 6 * (2 * std::pow(d_small, 3) + std::pow(d_large, 3)) / 3
                               : M_PI / 4 * (2 * std::pow(d_small, 2) + std::pow(d_large, 2)) / 3;
    EXPECT_NEAR(o.stages[0].to, static_cast<double>(o.grains.count) * area / std::pow(box[k], k == 2 ? 3 : 2), 6e-4);
  }
  const std::vector<Task> tasks = plan_tasks(s);
  ASSERT_EQ(tasks.size(), 60u);
  EXPECT_EQ(tasks[0].plan.frames.size(), 13u) << ".65 to .89";
  EXPECT_EQ(tasks[59].plan.frames.size(), 22u) << ".29 to .71";
}

TEST(BuiltinStudies, FinerStepsGoFromBelowJammingToAbove) {
  const Study s = read_study_text(builtin_file("networks-2d-3d-rho-j.toml"), "rho-j");
  const double rho_j[] = {0.834, 0.842, 0.570};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::vector<PlannedFrame> frames = plan(s.systems[k].options, task_key(s.systems[k].options, 1, 0)).frames;
    EXPECT_GT(frames.back().packing_fraction, rho_j[k] + 0.01);
    EXPECT_LT(frames.front().packing_fraction, rho_j[k] - 0.015);
    for (std::size_t f = 0; f < frames.size(); ++f) {
      EXPECT_TRUE(frames[f].relaxed);
      if (f == 0) continue;
      EXPECT_NEAR(frames[f].packing_fraction - frames[f - 1].packing_fraction, 0.005, 1e-9);
    }
  }
}

TEST(BuiltinStudies, OneSystemOfNetworksSharesItsRunsWithTheWhole) {
  const std::vector<Task> all = plan_tasks(read_study_text(builtin_file("networks-2d-3d.toml"), "whole"));
  for (const char* system : {"2d-linear", "2d-hertz", "3d-hertz"}) {
    const std::string file = std::string("networks-2d-3d-") + system + ".toml";
    const std::string hash = plan_tasks(read_study_text(builtin_file(file), file)).front().hash;
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Task& t) { return t.hash == hash; })) << file;
  }
}

}  // namespace
}  // namespace jam
