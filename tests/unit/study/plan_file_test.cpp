#include "jamscape/study/plan_file.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "jamscape/base/files.hpp"
#include "jamscape/study/task.hpp"
#include "small_study.hpp"

namespace jam {
namespace {

void expect_equal(const Plan& a, const Plan& b) {
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.bodies, b.bodies);
  EXPECT_EQ(a.start, b.start);
  EXPECT_EQ(a.axis, b.axis);
  ASSERT_EQ(a.frames.size(), b.frames.size());
  for (std::size_t k = 0; k < a.frames.size(); ++k) {
    EXPECT_EQ(a.frames[k].stage, b.frames[k].stage);
    EXPECT_EQ(a.frames[k].step, b.frames[k].step);
    EXPECT_EQ(a.frames[k].relaxed, b.frames[k].relaxed);
    if (std::isnan(a.frames[k].packing_fraction))
      EXPECT_TRUE(std::isnan(b.frames[k].packing_fraction));
    else
      EXPECT_EQ(a.frames[k].packing_fraction, b.frames[k].packing_fraction);
  }
}

struct Kept {
  ScratchFolder scratch{"plan-file-test"};
  SystemOptions system = read_study_text(small_study, "s.toml").systems[0].options;
  TaskFolder folder{scratch.path(), "0123456789abcdef"};
  Kept() { make_folder(folder.path()); }
};

Plan odd_plan() {
  Plan plan;
  plan.steps = 38103288, plan.bodies = 2025, plan.start = 0.1 + 0.2;
  plan.frames = {{"squeeze, then \"rest\"", 0.68, 12345678901, false},
                 {"2", 1.0 / 3, -1, true},
                 {"settle", std::nan(""), -1, false}};
  return plan;
}

TEST(PlanFile, AWholePlanComesBackToTheBit) {
  const Kept kept;
  EXPECT_FALSE(read_plan(kept.folder, kept.system).has_value());
  write_plan(kept.folder, kept.system, odd_plan());
  const auto back = read_plan(kept.folder, kept.system);
  ASSERT_TRUE(back.has_value());
  expect_equal(odd_plan(), *back);
}

TEST(PlanFile, OfOtherFramesOrDamagedItIsNoPlan) {
  const Kept kept;
  write_plan(kept.folder, kept.system, odd_plan());
  SystemOptions more = kept.system;
  more.stages.front().frames += 1;
  EXPECT_FALSE(read_plan(kept.folder, more).has_value());
  const std::string text = read_text(kept.folder.plan());
  write_text(kept.folder.plan(), text.substr(0, text.size() - 3));
  EXPECT_FALSE(read_plan(kept.folder, kept.system).has_value());
  const std::size_t last = text.rfind('\n', text.size() - 2) + 1;
  write_text(kept.folder.plan(), text.substr(0, last));
  EXPECT_FALSE(read_plan(kept.folder, kept.system).has_value()) << "a whole line less";
  std::string other = text;
  other.replace(other.find("0.68"), 4, "0.69");
  write_text(kept.folder.plan(), other);
  EXPECT_FALSE(read_plan(kept.folder, kept.system).has_value()) << "another number";
  write_text(kept.folder.plan(), text);
  EXPECT_TRUE(read_plan(kept.folder, kept.system).has_value());
}

TEST(PlanFile, TasksOfResultsHaveThePlansTheyWereRunBy) {
  const ScratchFolder scratch("plan-file-test");
  const Study study = read_study_text(small_study, "s.toml");
  std::vector<Task> planned = plan_tasks(study);
  for (const Task& task : planned) {
    const TaskFolder folder(scratch.path(), task.hash);
    make_folder(folder.path());
    write_plan(folder, study.systems[task.system].options, task.plan);
  }
  Task& known = planned.front();
  known.plan.steps += 1;  // that the list is asked, and nothing planned
  write_plan(TaskFolder(scratch.path(), known.hash), study.systems[known.system].options, known.plan);
  const std::vector<Task> stored = stored_tasks(study, scratch.path());
  ASSERT_EQ(stored.size(), planned.size());
  for (std::size_t k = 0; k < stored.size(); ++k) {
    EXPECT_EQ(stored[k].hash, planned[k].hash);
    EXPECT_EQ(stored[k].key.system, planned[k].key.system);
    expect_equal(planned[k].plan, stored[k].plan);
  }
}

}  // namespace
}  // namespace jam
