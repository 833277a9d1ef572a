// How the relaxations ended before the frames of a study, from the column `relaxation` of tables/frames.csv.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "jamscape/base/table.hpp"
#include "jamscape/study/study.hpp"

namespace jam {

/// Of the realisations of one system at one frame.
struct RelaxationCount {
  std::int64_t fluctuation = 0;  ///< ended by the criterion on the fluctuation of the kinetic energy
  std::int64_t energy = 0;       ///< ended because the kinetic energy is negligible
  std::int64_t budget = 0;       ///< not relaxed when the budget was spent

  std::int64_t runs() const { return fluctuation + energy + budget; }
};

/// Per system of the study, by frame; frames that follow no relaxation are not in it.
using Relaxations = std::vector<std::map<std::int64_t, RelaxationCount>>;

/// How many realisations of a system were not relaxed at a frame.
std::int64_t unrelaxed_runs(const std::map<std::int64_t, RelaxationCount>& system, std::int64_t frame);

Relaxations count_relaxations(const Study& study, const Table& frames);

}  // namespace jam
