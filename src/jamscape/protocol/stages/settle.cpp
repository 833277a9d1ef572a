#include "jamscape/protocol/stages/settle.hpp"

#include <algorithm>
#include <cmath>

#include "jamscape/base/error.hpp"
#include "jamscape/protocol/container_timetable.hpp"

namespace jam {
namespace {

/// A guess, from S3's systems (validation/): at rest after 1.2 to 1.6 times the fall (nearly round stars in a cylinder
/// never are, and take the budget).
constexpr double falls_to_rest = 1.3;

}  // namespace

void Settle::write(const StageOptions& stage, ContainerTimetable& table) {
  if (!(table.gravity() > 0))
    throw usage_error("stage." + table.stage() + ".kind: nothing settles without gravity", {},
                      "domain.gravity = \"9.81 m/s^2\"");
  const double fall = std::sqrt(2 * table.height() / table.gravity());
  Leg leg;
  leg.steps = steps_for(stage.settle_times * fall, table.time_step());
  if (stage.settle_until == SettleUntil::rest) {
    leg.kind = LegKind::relax;
    leg.relax = stage.relax;
    leg.relax.fluctuation = 0;
    leg.relax.windows = static_cast<double>(leg.steps) / static_cast<double>(stage.relax.window);
    leg.steps = std::min(leg.steps, steps_for(falls_to_rest * fall, table.time_step()));
  }
  table.add(leg);
}

}  // namespace jam
