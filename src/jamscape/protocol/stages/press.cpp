#include "jamscape/protocol/stages/press.hpp"

#include "jamscape/base/error.hpp"
#include "jamscape/protocol/container_timetable.hpp"

namespace jam {
namespace {

/// A guess, from S3's systems (validation/): the lid goes .001 to .03 of the height.
constexpr double lid_travel = 0.01;

}  // namespace

void Press::write(const StageOptions& stage, ContainerTimetable& table) {
  if (!(stage.force > 0))
    throw usage_error("stage." + table.stage() + ".force: the lid needs a force to stop at", {}, "force = \"500 N\"");
  Leg leg;
  leg.kind = LegKind::press;
  leg.speed = stage.speed;
  leg.force = stage.force;
  leg.steps = steps_for(lid_travel * table.height(), stage.speed * table.time_step());
  table.add(leg);
}

}  // namespace jam
