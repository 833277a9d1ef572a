// One simulation, from wherever it was left to its end, into the folder of its task.
#pragma once

#include <functional>
#include <string>

#include "jamscape/study/study.hpp"
#include "jamscape/study/task.hpp"
#include "jamscape/study/task_folder.hpp"

namespace jam {

struct SimulateHooks {
  std::function<void(const Progress&)> progress;
  std::function<bool()> stop;
  std::function<void(const std::string&)> warning = {};
  double checkpoint_interval = 60;  ///< seconds between checkpoints; saving changes no bit of the simulation
  int threads = 1;                  ///< see Hooks
};

/// The resolved study of this one task: what task.toml and run.h5 say about it.
std::string task_text(const Study& study, const Task& task);

/// Simulates what is missing. Returns `stopped` when hooks.stop() asked for it (a checkpoint is kept), `finished` when
/// run.h5 holds every planned frame. A damaged run.h5, and frames taken so far that cannot be read, are set aside
/// (TaskFolder) with a warning, and simulated again; a run.h5 that is of a later version, or that may not be read, is a
/// data error and stays. Throws
/// what the engine or the disk throws; the last checkpoint stays. The caller holds the lock of the folder.
Outcome simulate_task(const Study& study, const Task& task, const TaskFolder& folder, const SimulateHooks& hooks);

}  // namespace jam
