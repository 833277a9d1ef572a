// What a task has cost so far, from its log.
#pragma once

#include <cstdint>

#include "jamscape/study/task_folder.hpp"

namespace jam {

struct TimeSpent {
  bool finished = false;
  double seconds = 0;  ///< on the clock, all its pieces from start or resume to stop or end
  /// Of the processor, by the thread that led it, so whatever else the machine did; on the clock where an old log does
  /// not have it.
  double core_seconds = 0;
  std::int64_t steps = 0;  ///< of the finished run
  std::int64_t bodies = 0;

  /// Grain-steps a second of a finished run, else 0.
  double rate() const {
    return finished && core_seconds > 0 ? static_cast<double>(steps) * static_cast<double>(bodies) / core_seconds : 0;
  }
};

/// Never throws: without a log, or with lines that cannot be read, nothing was spent. A run that was killed has lost
/// the time of its last piece.
TimeSpent time_spent(const TaskFolder& folder) noexcept;

}  // namespace jam
