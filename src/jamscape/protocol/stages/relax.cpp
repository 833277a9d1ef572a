#include "jamscape/protocol/stages/relax.hpp"

#include <algorithm>

#include "jamscape/protocol/box_timetable.hpp"
#include "jamscape/protocol/container_timetable.hpp"

namespace jam {

/// Kinetic energies level off within two windows; where only their size counts, the budget is what most runs need.
std::int64_t guess_relaxation(const RelaxOptions& o) {
  const double windows = o.fluctuation > 0 ? std::min(2.0, o.windows) : o.windows;
  return static_cast<std::int64_t>(windows * static_cast<double>(o.window));
}

void Relax::write(const StageOptions& stage, BoxTimetable& table) {
  table.close_to_start();
  table.rest(stage.relax);
}

void Relax::write(const StageOptions& stage, ContainerTimetable& table) {
  Leg leg;
  leg.kind = LegKind::relax;
  leg.relax = stage.relax;
  leg.steps = guess_relaxation(stage.relax);
  table.add(leg, FrameIs::relaxed);
}

}  // namespace jam
