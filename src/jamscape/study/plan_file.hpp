// DIR/tasks/<hash>/plan.csv: which frames a task is asked for, written by whoever plans it, before anything is
// simulated. Whatever looks at results afterwards (report, score, export, status) asks this list and the stored frames,
// so that it plans nothing and draws no grains; results that come from files of other programs have such a list as
// well.
//
//   # key: hash of the options that planned it; another study plans anew
//   # sum: hash of everything below, so that a list cut short or changed is planned anew, too
//   # steps, bodies, start: what the whole run takes (Plan)
//   stage,packing_fraction,step,relaxed      a row a frame; an empty packing fraction is what comes out
#pragma once

#include <optional>

#include "jamscape/protocol/simulate.hpp"
#include "jamscape/study/task_folder.hpp"

namespace jam {

/// Into an existing folder, unless it holds the same already.
void write_plan(const TaskFolder& folder, const SystemOptions& system, const Plan& plan);

/// Nothing where there is none, where other options planned it, or where its content is not what was written.
std::optional<Plan> read_plan(const TaskFolder& folder, const SystemOptions& system);

}  // namespace jam
