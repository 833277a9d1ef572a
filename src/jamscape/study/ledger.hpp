// Which frames of a task are marked: those whose energy ledger is off by more than study.ledger_mark of what was turned
// over (protocol/ledger.hpp). Where the rows of a task do not tell (tables of earlier versions), nothing is known and
// nothing is marked.
#pragma once

#include <cstddef>
#include <vector>

#include "jamscape/study/done_tasks.hpp"
#include "jamscape/study/study.hpp"

namespace jam {

/// By frame of the plan; NaN where it is not known.
std::vector<double> ledger_errors(const Study& study, const DoneTask& done);

/// Of one system.
struct MarkedFrames {
  std::size_t frames = 0, runs = 0;  ///< marked; of so many runs
  double from = 0;                   ///< lowest packing fraction among them
  double worst = 0;                  ///< largest ledger_error
};
MarkedFrames count_marked(const std::vector<const DoneTask*>& done);

}  // namespace jam
