// The measured rows of tasks that are done, as numbers: what tables, ensemble means, transitions and scores are made
// of.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "jamscape/observe/measure.hpp"
#include "jamscape/study/measure_task.hpp"
#include "jamscape/study/study.hpp"
#include "jamscape/study/task.hpp"
#include "jamscape/study/task_folder.hpp"

namespace jam {

/// A task whose run.h5 holds every planned frame and whose rows have been measured.
struct DoneTask {
  const Task* task = nullptr;
  TaskFolder folder;
  std::vector<std::size_t> stored;  ///< index in run.h5 of each planned frame
};

/// Those that are done and have rows of all these measures, in the order of the tasks.
std::vector<DoneTask> find_done(const std::vector<Task>& tasks, const std::filesystem::path& results,
                                const std::vector<const Measure*>& measures);

/// Quantities of one row a frame, of all realisations of one system.
struct FrameSeries {
  std::vector<double> target;         ///< planned packing fraction of each frame
  std::vector<std::string> quantity;  ///< packing_fraction, packing_fraction_plain, then the measures' columns
  std::vector<std::vector<std::vector<double>>> value;  ///< [quantity][realisation][frame]
  std::size_t realisations = 0;

  /// [realisation][frame], or nullptr for a quantity that was not measured.
  const std::vector<std::vector<double>>* find(std::string_view name) const;
};

/// Frames that not all realisations have are left out. Throws a data error for damaged rows.
FrameSeries read_frame_series(const std::vector<const DoneTask*>& done, const std::vector<const Measure*>& measures);

/// The rows of a measure with several rows a frame: [frame][row][column], without the frame column.
using FrameRows = std::vector<std::vector<std::vector<double>>>;
FrameRows read_frame_rows(const DoneTask& done, const Measure& measure);

/// The tasks of each system.
std::vector<std::vector<const DoneTask*>> by_system(const Study& study, const std::vector<DoneTask>& done);

}  // namespace jam
