// Tables kept without the simulations they come from, one file per system: DIR/SYSTEM.csv.gz with the columns of
// tables/frames.csv, and DIR/SYSTEM.MEASURE.csv.gz for measures with several rows a frame (validation/collect writes
// them). Such a folder can be scored and reported like the results it was taken from; what it has no columns of counts
// as not measured.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "jamscape/observe/measure.hpp"
#include "jamscape/protocol/simulate.hpp"
#include "jamscape/study/measure_task.hpp"

namespace jam {

/// The rows of one realisation.
struct CollectedTask {
  std::vector<PlannedFrame> frames;
  std::map<std::string, CachedRows> rows;  ///< by measure, with instant and relaxation among them
};

/// True for a folder that holds such tables and no tasks.
bool is_collected(const std::filesystem::path& folder);

/// By realisation. Empty when there is no table of the system; throws a data error for a damaged one.
std::map<std::uint64_t, CollectedTask> read_collected(const std::filesystem::path& folder, const std::string& system,
                                                      const std::vector<const Measure*>& measures);

}  // namespace jam
