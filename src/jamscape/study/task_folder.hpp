// The folder of a task, DIR/tasks/<hash>/:
//
//   task.toml       what it is: a study file of this one system, and who simulated it
//   plan.csv        which frames it is asked for (plan_file.hpp)
//   frames/*.h5     frames taken so far (index in the plan, six digits), until the task ends
//   frames.damaged-N/   frames that could not be read when the task ended; it was simulated again
//   checkpoint.h5   the complete state to go on from, until the task ends
//   run.h5          all frames, once it has ended: a task with run.h5 is done
//   run.damaged-N.h5    one that was found damaged; it was simulated again
//   failed.txt      why it could not go on, until it is tried again
//   tables/         its rows of the measures (measure_task.hpp)
//   log.jsonl       what happened, when, and how long it took
//   lock            held by the process that works on it
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "jamscape/io/run_file.hpp"
#include "jamscape/study/study.hpp"
#include "jamscape/study/task.hpp"

namespace jam {

enum class TaskState { waiting, started, done, failed };

class TaskFolder {
 public:
  TaskFolder(const std::filesystem::path& results, const std::string& hash) : TaskFolder(results, hash, results) {}
  /// With its rows of the measures elsewhere: below `rows` as they would be below `results`.
  TaskFolder(const std::filesystem::path& results, const std::string& hash, const std::filesystem::path& rows)
      : path_(results / "tasks" / hash), tables_(rows / "tasks" / hash / "tables") {}

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path run_file() const { return path_ / "run.h5"; }
  std::filesystem::path plan() const { return path_ / "plan.csv"; }
  std::filesystem::path checkpoint() const { return path_ / "checkpoint.h5"; }
  std::filesystem::path frame(std::size_t index) const;
  std::filesystem::path frames() const { return path_ / "frames"; }
  const std::filesystem::path& tables() const { return tables_; }
  std::filesystem::path lock() const { return path_ / "lock"; }

  /// What the files say; whether run.h5 holds the frames wanted now is another question (stored_frames()).
  TaskState state() const;
  /// The reason in failed.txt, or "".
  std::string failure() const;

  /// Appends a line to log.jsonl; trouble with the log is nobody's trouble.
  void log(const std::string& json_line) const noexcept;

  /// Removes frames and checkpoint of an unfinished run.
  void discard_partial() const;
  /// Renames the folder of frames and removes the checkpoint; returns the new name.
  std::filesystem::path set_aside_frames() const;
  /// Renames run.h5 and returns the new name; throws a data error when that fails.
  std::filesystem::path set_aside_run() const;

 private:
  std::filesystem::path path_, tables_;
};

/// For each planned frame its index in the run file; nothing when one is missing there. Taking a frame changes no bit
/// of the simulation, so frames are told apart by their step, or by their packing fraction where that is not planned.
std::optional<std::vector<std::size_t>> stored_frames(const RunFile& run, const Plan& plan);

/// Looks at every byte of run.h5; nothing when there is none.
std::optional<RunCheck> check_stored(const TaskFolder& folder);

/// True when the task is done and holds every planned frame, as far as the names in run.h5 say; false for one that
/// cannot be opened. Whether its content is whole is for check_stored() to say.
bool has_all_frames(const TaskFolder& folder, const Plan& plan);

}  // namespace jam
