// The timetable of a protocol: its stages taken apart into legs, and the frames taken on each.
#pragma once

#include <string>
#include <vector>

#include "jamscape/protocol/simulate.hpp"

namespace jam {

enum class LegKind {
  move,   ///< the walls move at one speed (or none) for a known time
  relax,  ///< they stand still until the grains have come to rest
  press   ///< the lid comes down from above the highest grain until it carries a force
};

struct Leg {
  std::string stage;
  LegKind kind = LegKind::move;
  double speed = 0;        ///< of each wall, or of the lid
  std::int64_t steps = 0;  ///< relax, press: a guess
  RelaxOptions relax{};
  double force = 0;  ///< press
};

struct Timetable {
  Plan plan;
  std::vector<Leg> legs;
  /// Where each frame of the plan is taken: on which leg, how many steps after its beginning (relax, press: at its
  /// end).
  struct FramePlace {
    std::size_t leg = 0;
    std::int64_t offset = 0;
  };
  std::vector<FramePlace> places;
};

/// Steps until what moves by `rate` a step has gone `travel`; rounding never adds a step.
std::int64_t steps_for(double travel, double rate);

/// Throws a usage error for a protocol that cannot be (see plan()).
Timetable timetable(const SystemOptions& system, const TaskKey& key);

}  // namespace jam
