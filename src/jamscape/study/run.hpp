// Runs a study: simulates what is missing, measures what is missing, in parallel over tasks.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "jamscape/study/study.hpp"
#include "jamscape/study/task.hpp"

namespace jam {

/// Told what happens; called from several threads at once, except tick().
class RunListener {
 public:
  virtual ~RunListener() = default;
  /// `resumed`: it goes on from a checkpoint.
  virtual void started(std::size_t /*task*/, bool /*resumed*/) {}
  virtual void progress(std::size_t /*task*/, const Progress&) {}
  virtual void measuring(std::size_t /*task*/) {}
  /// Something was wrong and has been mended.
  virtual void warned(std::size_t /*task*/, const std::string& /*reason*/) {}
  /// `simulated` is false for a task that was done before.
  virtual void finished(std::size_t /*task*/, bool /*simulated*/) {}
  virtual void failed(std::size_t /*task*/, const std::string& /*reason*/) {}
  /// Another process works on it.
  virtual void skipped(std::size_t /*task*/) {}
  /// A few times a second, from the thread that called run_tasks().
  virtual void tick() {}
};

struct RunOptions {
  int jobs = 1;
  int threads = 1;  ///< of one simulation, see Hooks
  Shard shard;
  double checkpoint_interval = 60;
  std::function<bool()> stop;  ///< polled: true saves checkpoints and returns
};

struct RunResult {
  std::size_t done = 0, simulated = 0, failed = 0, skipped = 0;
  bool interrupted = false;
  bool complete = false;  ///< every task of the study, of all shards, is done or has failed
};

/// Simulates and measures the tasks of this shard. A task that fails is recorded in its folder and the others go on.
/// The folder of results has been made, and the caller holds its RunnerLock.
RunResult run_tasks(const Study& study, const std::vector<Task>& tasks, const std::filesystem::path& results,
                    const RunOptions& options, RunListener& listener);

}  // namespace jam
