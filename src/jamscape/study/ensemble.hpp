// DIR/ensemble/*.csv: means over the realisations of a system, in long form:
//
//   system, <options that differ between systems>, frame, packing_fraction_target, [abscissae], quantity, n, mean, sd,
//   se, marked
//
// for frames.csv (one row a frame, all its quantities) and for every averaged measure with several rows a frame; pooled
// ratios of a measure follow its columns. Each column says how it is averaged (averaging.hpp); n counts the values
// behind a mean. `marked` counts the realisations whose frame is marked (ledger.hpp): they are not among the n, or they
// are, where the study says ledger = "open".
#pragma once

#include <filesystem>
#include <vector>

#include "jamscape/study/done_tasks.hpp"
#include "jamscape/study/study.hpp"

namespace jam {

void write_ensemble(const Study& study, const std::vector<DoneTask>& done, const std::filesystem::path& results);

}  // namespace jam
