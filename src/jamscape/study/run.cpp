#include "jamscape/study/run.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "jamscape/base/error.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/base/threads.hpp"
#include "jamscape/study/measure_task.hpp"
#include "jamscape/study/plan_file.hpp"
#include "jamscape/study/simulate_task.hpp"

namespace jam {
namespace {

namespace fs = std::filesystem;

enum class Ending { done_before, simulated, stopped, failed, skipped };

void record_failure(const TaskFolder& folder, const std::string& reason) noexcept {
  try {
    folder.log(nlohmann::json{{"event", "failed"}, {"reason", reason}}.dump());
    write_text(folder.path() / "failed.txt", reason + "\n");
  } catch (...) {  // the disk that made the task fail may be full here too; the caller still counts the failure
  }
}

class Runner {
 public:
  Runner(const Study& study, const std::vector<Task>& tasks, const fs::path& results, const RunOptions& options,
         RunListener& listener)
      : study_(study),
        tasks_(tasks),
        results_(results),
        options_(options),
        listener_(listener),
        measures_(chosen_measures(study)) {}

  RunResult run() {
    const std::vector<std::size_t> order = order_tasks(tasks_, options_.shard);
    std::vector<Ending> endings(order.size(), Ending::stopped);
    run_jobs(
        order.size(), options_.jobs, [&](std::size_t k) { endings[k] = run_one(order[k]); }, [&] { listener_.tick(); });
    RunResult result;
    for (const Ending ending : endings) {
      result.done += ending == Ending::done_before || ending == Ending::simulated;
      result.simulated += ending == Ending::simulated;
      result.failed += ending == Ending::failed;
      result.skipped += ending == Ending::skipped;
      result.interrupted = result.interrupted || ending == Ending::stopped;
    }
    result.complete = !result.interrupted && everything_ended();
    return result;
  }

 private:
  bool stopping() const { return options_.stop && options_.stop(); }

  Ending run_one(std::size_t index) {
    if (stopping()) return Ending::stopped;
    const Task& task = tasks_[index];
    const TaskFolder folder(results_, task.hash);
    try {
      make_folder(folder.path());
      const auto lock = FileLock::try_lock(folder.lock());
      if (!lock) {
        listener_.skipped(index);
        return Ending::skipped;
      }
      write_plan(folder, study_.systems[task.system].options, task.plan);
      bool done = has_all_frames(folder, task.plan);
      if (!done) listener_.started(index, fs::exists(folder.checkpoint()));
      fs::remove(folder.path() / "failed.txt");
      SimulateHooks hooks{[&](const Progress& p) { listener_.progress(index, p); }, [this] { return stopping(); },
                          [&](const std::string& reason) {
                            listener_.warned(index, reason);
                            if (std::exchange(done, false)) listener_.started(index, false);
                          },
                          options_.checkpoint_interval, options_.threads};
      if (simulate_task(study_, task, folder, hooks) == Outcome::stopped) return Ending::stopped;
      listener_.measuring(index);
      measure_task(folder, measures_, measure_options(study_, task.system), Remeasure::missing, hooks.stop);
      if (stopping()) return Ending::stopped;
      listener_.finished(index, !done);
      return done ? Ending::done_before : Ending::simulated;
    } catch (const std::exception& error) {
      record_failure(folder, error.what());
      listener_.failed(index, error.what());
      return Ending::failed;
    }
  }

  bool everything_ended() const {
    for (const Task& task : tasks_) {
      const TaskFolder folder(results_, task.hash);
      if (folder.state() != TaskState::failed && !has_all_frames(folder, task.plan)) return false;
    }
    return true;
  }

  const Study& study_;
  const std::vector<Task>& tasks_;
  fs::path results_;
  const RunOptions& options_;
  RunListener& listener_;
  std::vector<const Measure*> measures_;
};

}  // namespace

RunResult run_tasks(const Study& study, const std::vector<Task>& tasks, const fs::path& results,
                    const RunOptions& options, RunListener& listener) {
  return Runner(study, tasks, results, options, listener).run();
}

}  // namespace jam
