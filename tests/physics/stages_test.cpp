// Kinds of stages: what follows from their list.
#include <gtest/gtest.h>

#include "compression.hpp"
#include "jamscape/base/error.hpp"
#include "jamscape/protocol/plan.hpp"

namespace jam {
namespace {

SystemOptions container() {
  SystemOptions s;
  s.grains.count = 20;
  s.grains.shape = BodyShape::cross;
  s.domain.walls = WallModel::box;
  s.domain.gravity = 0.1;
  return s;
}

StageOptions stage(StageKind kind) {
  StageOptions stage = compression("mine", 0.7, 1e-2, 0);
  stage.kind = kind;
  stage.force = 1;
  return stage;
}

std::string refusal(const SystemOptions& system) {
  try {
    timetable(system, {1, "stages", 0});
  } catch (const Error& e) {
    return e.problem() + " | " + e.suggestion();
  }
  return "";
}

TEST(Stages, each_kind_is_written_where_it_says_and_refused_elsewhere) {
  for (const StageInfo& info : stage_kinds()) {
    SCOPED_TRACE(info.name);
    EXPECT_EQ(stage_info(info.kind).name, info.name);
    EXPECT_TRUE(info.in_box || info.in_container);
    SystemOptions box, pressed = container();
    box.grains.count = 100;
    box.stages = pressed.stages = {stage(info.kind)};
    const std::string none = "stage.mine.kind: there is no stage \"" + std::string(info.name) + "\" in a ";
    EXPECT_EQ(refusal(box).substr(0, none.size()), info.in_box ? "" : none);
    EXPECT_EQ(refusal(pressed), info.in_container ? "" : none + "container | relax, settle and press");
  }
}

TEST(Stages, frames_go_by_what_their_domain_says) {
  SystemOptions box, pressed = container();
  box.grains.count = 100;
  box.stages = {stage(StageKind::steps)};
  pressed.stages = {stage(StageKind::settle)};
  EXPECT_TRUE(plan(box, {}).axis->planned);
  EXPECT_FALSE(plan(pressed, {}).axis->planned);
}

TEST(Stages, only_frames_are_forgotten) {
  StageOptions s = stage(StageKind::steps);
  s.frames = 3, s.frames_at = {0.7}, s.frames_inside = 2;
  s.forget_frames();
  EXPECT_EQ(s.frames, 0);
  EXPECT_TRUE(s.frames_at.empty());
  EXPECT_EQ(s.frames_inside, 0);
  EXPECT_EQ(s.to, 0.7);
  EXPECT_EQ(s.kind, StageKind::steps);
}

TEST(Stages, frames_of_ones_own_are_refused_where_a_stage_has_others) {
  SystemOptions s;
  s.grains.count = 100;
  s.stages = {stage(StageKind::steps)};
  s.stages[0].frames_at = {0.65};
  EXPECT_EQ(refusal(s), "stage.mine.frames_at: only stages of kind = \"compress\" have it | frames_inside");
  s.stages = {stage(StageKind::relax)};
  s.stages[0].frames = 2;
  EXPECT_EQ(refusal(s),
            "stage.mine.frames: only stages of kind = \"compress\" have it | this stage has one frame, at its end");
}

TEST(Stages, their_text_names_all) {
  const std::string text(stage_kinds_text());
  for (const StageInfo& info : stage_kinds()) EXPECT_NE(text.find(std::string(info.name) + " "), std::string::npos);
}

}  // namespace
}  // namespace jam
