// The timetable of a protocol: which steps belong to which stage, and at which steps frames are taken.
#pragma once

#include <string>
#include <vector>

#include "jamscape/protocol/box.hpp"
#include "jamscape/protocol/simulate.hpp"

namespace jam {

struct PlannedStage {
  std::string name;
  std::int64_t first = 0, steps = 0;
  double speed = 0;  ///< of each wall
};

struct Timetable {
  Plan plan;
  BoxMeasure box;
  std::vector<PlannedStage> stages;
};

/// Throws a usage error for a protocol that cannot be (see plan()).
Timetable timetable(const SystemOptions& system, const TaskKey& key);

}  // namespace jam
