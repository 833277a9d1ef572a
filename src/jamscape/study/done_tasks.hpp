// The measured rows of tasks that are done, as numbers: what tables, ensemble means, transitions and scores are made
// of.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "jamscape/observe/measure.hpp"
#include "jamscape/study/collected.hpp"
#include "jamscape/study/measure_task.hpp"
#include "jamscape/study/states.hpp"
#include "jamscape/study/study.hpp"
#include "jamscape/study/task.hpp"
#include "jamscape/study/task_folder.hpp"

namespace jam {

/// A task whose run.h5 holds every planned frame and whose rows have been measured, or whose rows are kept in tables.
struct DoneTask {
  const Task* task = nullptr;
  TaskFolder folder;
  std::vector<PlannedFrame> frames;       ///< those of a container have the mean packing fraction reached
  std::vector<std::size_t> stored;        ///< index of each frame in run.h5 and in the cached rows
  std::vector<double> ledger_error = {};  ///< of each frame (ledger.hpp); NaN where unknown
  std::vector<bool> marked = {};          ///< above study.ledger_mark
  std::vector<bool> left_out = {};        ///< marked, in a study whose means take no such frame
  std::shared_ptr<const CollectedTask> collected = nullptr;  ///< in place of the folder, where tables are all there is
};

/// The folder of a task, with its rows of these measures where they are kept.
TaskFolder folder_with_rows(const ResultPlaces& places, const std::string& hash,
                            const std::vector<const Measure*>& measures);

/// Those that are done, are not left out, and have rows of all measures of the study (from tables: of any), in the
/// order of the tasks.
std::vector<DoneTask> find_done(const Study& study, const std::vector<Task>& tasks, const ResultPlaces& places,
                                const std::vector<LeftOut>& left_out = {});

/// The measures of the study that all these tasks have rows of.
std::vector<const Measure*> measured(const Study& study, const std::vector<DoneTask>& done);

CachedRows read_rows(const DoneTask& done, const Measure& measure);

/// What ended the relaxation before each frame; empty texts where there was none.
std::vector<std::string> relaxations(const DoneTask& done);
/// Frames of these tasks whose relaxation ran out of its budget.
std::size_t frames_not_relaxed(const std::vector<DoneTask>& done);
/// True when a system of the study relaxes, and so its tables say how.
bool relaxes(const Study& study);

/// Quantities of one row a frame, of all realisations of one system.
struct FrameSeries {
  std::vector<double> target;         ///< planned packing fraction of each frame; in a container the mean reached
  std::vector<FrameKind> kinds;       ///< stage, packing fraction, whether relaxed
  std::vector<std::string> quantity;  ///< packing_fraction, packing_fraction_plain, the measures' columns, and where
                                      ///< frames are relaxed `not_relaxed`: 1 where that ran out of its budget
  std::vector<Averaging> averaging;   ///< of each quantity
  std::vector<std::vector<std::vector<double>>> value;  ///< [quantity][realisation][frame]; NaN where left out
  std::vector<std::size_t> marked;                      ///< of each frame, how many realisations have it marked
  std::vector<bool> left_out;                           ///< of each frame, whether a realisation is left out
  std::size_t realisations = 0;

  /// [realisation][frame], or nullptr for a quantity that was not measured.
  const std::vector<std::vector<double>>* find(std::string_view name) const;
  /// Indices of the frames that curves over the packing fraction are made of.
  std::vector<std::size_t> states() const { return find_states(kinds).frames; }
  /// True where those are relaxed.
  bool relaxed() const { return find_states(kinds).relaxed; }
};

/// Frames that not all realisations have are left out, and of realisations whose frames lie elsewhere than those of the
/// first (tables of earlier versions) the values are NaN. Throws a data error for damaged rows.
FrameSeries read_frame_series(const std::vector<const DoneTask*>& done, const std::vector<const Measure*>& measures);

/// The rows of a measure with several rows a frame: [frame][row][column], without the frame column.
using FrameRows = std::vector<std::vector<std::vector<double>>>;
FrameRows read_frame_rows(const DoneTask& done, const Measure& measure);

/// The tasks of each system.
std::vector<std::vector<const DoneTask*>> by_system(const Study& study, const std::vector<DoneTask>& done);

}  // namespace jam
