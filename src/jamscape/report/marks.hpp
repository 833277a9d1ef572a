// Frames of tables/frames.csv that curves are made of (study/states.hpp), and those whose energy ledger is off (the
// columns `marked` and `ledger_error`).
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "jamscape/base/table.hpp"
#include "jamscape/study/study.hpp"

namespace jam {

/// Per system of the study; empty for a system all of whose frames count.
using FrameSets = std::vector<std::set<std::int64_t>>;
FrameSets frames_of_curves(const Study& study, const Table& frames);

/// Of one system.
struct Mark {
  std::map<std::int64_t, std::int64_t> frames;  ///< realisations that have this frame marked
  double worst = 0;                             ///< largest ledger_error among them
  double from = 0;                              ///< lowest packing fraction among them
};
using Marks = std::vector<Mark>;
Marks count_marks(const Study& study, const Table& frames);

}  // namespace jam
