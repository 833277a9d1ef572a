// The timetable of a protocol: its stages taken apart into legs, and the frames taken on each.
#pragma once

#include <string>
#include <vector>

#include "jamscape/protocol/box.hpp"
#include "jamscape/protocol/simulate.hpp"

namespace jam {

/// Walls that move at one speed for a known time, or stand still until the grains have come to rest.
struct Leg {
  std::string stage;
  bool relaxes = false;
  double speed = 0;        ///< of each wall
  std::int64_t steps = 0;  ///< relaxes: a guess
  RelaxOptions relax{};
};

struct Timetable {
  Plan plan;
  BoxMeasure box;
  std::vector<Leg> legs;
  /// Where each frame of the plan is taken: on which leg, how many steps after its beginning (relaxed: at its end).
  struct FramePlace {
    std::size_t leg = 0;
    std::int64_t offset = 0;
  };
  std::vector<FramePlace> places;
};

/// Throws a usage error for a protocol that cannot be (see plan()).
Timetable timetable(const SystemOptions& system, const TaskKey& key);

}  // namespace jam
