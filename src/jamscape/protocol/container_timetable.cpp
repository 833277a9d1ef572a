#include "jamscape/protocol/container_timetable.hpp"

#include <limits>
#include <utility>

namespace jam {

ContainerTimetable::ContainerTimetable(const SystemOptions& system, double height)
    : gravity_(system.domain.gravity), height_(height), dt_(system.integrator.step) {
  table_.plan.axis = &reached_packing_fraction;
}

void ContainerTimetable::add(Leg leg, FrameIs frame) {
  leg.stage = stage_;
  clock_known_ = clock_known_ && leg.kind == LegKind::move;
  const std::int64_t end = table_.plan.steps + leg.steps;
  table_.plan.frames.push_back(
      {stage_, std::numeric_limits<double>::quiet_NaN(), clock_known_ ? end : -1, frame == FrameIs::relaxed});
  table_.places.push_back({table_.legs.size(), leg.steps});
  table_.plan.steps = end;
  table_.legs.push_back(std::move(leg));
}

}  // namespace jam
