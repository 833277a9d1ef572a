#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "jamscape/base/cores.hpp"
#include "jamscape/base/progress.hpp"
#include "jamscape/study/damage.hpp"
#include "jamscape/study/results.hpp"
#include "jamscape/study/task_folder.hpp"
#include "jamscape/study/time_spent.hpp"
#include "status_times.hpp"

namespace jam::app {
namespace {

namespace fs = std::filesystem;

/// Is somebody at work on it? Asking takes and gives back the lock.
bool running(const TaskFolder& folder) {
  std::error_code ignored;
  return fs::exists(folder.lock(), ignored) && !FileLock::try_lock(folder.lock(), LockMode::shared);
}

std::size_t frames_taken(const TaskFolder& folder) {
  std::error_code ignored;
  std::size_t n = 0;
  for (const auto& entry : fs::directory_iterator(folder.frames(), ignored)) n += entry.path().extension() == ".h5";
  return n;
}

ExitCode status(const std::string& dir, bool as_json, bool times) {
  const Study study = study_of_results(dir);
  const std::vector<Task> tasks = stored_tasks(study, dir);
  if (times && !as_json) {
    print_times(dir, study, tasks);
    return ExitCode::done;
  }
  std::size_t done = 0, failed = 0, at_work = 0;
  double left = 0, rate = 0, rates = 0;
  nlohmann::json list = nlohmann::json::array();
  const std::vector<LeftOut> damaged = find_damage(tasks, dir, usable_cores());
  for (const std::size_t k : order_tasks(tasks, {})) {
    const Task& t = tasks[k];
    const TaskFolder folder(dir, t.hash);
    const auto bad = std::find_if(damaged.begin(), damaged.end(), [&](const LeftOut& l) { return l.hash == t.hash; });
    const bool busy = running(folder), complete = bad == damaged.end() && has_all_frames(folder, t.plan);
    std::string failure = busy || complete ? "" : folder.failure();
    if (!busy && bad != damaged.end()) failure = bad->reason;
    const std::string state = busy                                   ? "running"
                              : complete                             ? "done"
                              : !failure.empty()                     ? "failed"
                              : folder.state() == TaskState::waiting ? "waiting"
                                                                     : "interrupted";
    const std::size_t taken = complete ? t.plan.frames.size() : frames_taken(folder);
    done += complete, at_work += busy, failed += state == "failed";
    if (!complete && !t.plan.frames.empty())
      left += t.cost() * (1 - static_cast<double>(taken) / static_cast<double>(t.plan.frames.size()));
    const TimeSpent spent = time_spent(folder);
    if (const double r = spent.rate(); r > 0) rate += r, rates += 1;
    const std::string& system = study.systems[t.system].name;
    if (as_json)
      list.push_back({{"task", t.hash},
                      {"system", system},
                      {"realisation", t.realisation},
                      {"state", state},
                      {"frames", taken},
                      {"frames_planned", t.plan.frames.size()},
                      {"steps", spent.steps},
                      {"grains", t.plan.bodies},
                      {"seconds", spent.seconds},
                      {"core_seconds", spent.core_seconds},
                      {"reason", failure}});
    else
      fmt::print("{}  {:24}  realisation {:3}  {:11}  {:4}/{} frames{}\n", t.hash, system, t.realisation, state, taken,
                 t.plan.frames.size(), failure.empty() ? "" : "\n    " + failure);
  }
  const std::size_t total = order_tasks(tasks, {}).size();
  const int cores = usable_cores();
  const double seconds = rates > 0 ? left / (rate / rates) / cores : -1;
  if (as_json) {
    nlohmann::json all{{"tasks", list}, {"done", done}, {"running", at_work}, {"failed", failed}, {"total", total}};
    if (seconds >= 0) all["seconds_left"] = seconds;
    fmt::print("{}\n", all.dump());
  } else {
    fmt::print("{} of {} runs done, {} running, {} failed", done, total, at_work, failed);
    if (done < total && seconds >= 0) fmt::print("; about {} left on {} cores", print_duration(seconds), cores);
    fmt::print("\n");
  }
  return damaged.empty() ? ExitCode::done : ExitCode::data;
}

}  // namespace

void add_status(CLI::App& program, Action& action) {
  CLI::App* sub =
      program.add_subcommand("status", "What is done, running and left of a study, and how long it will take");
  auto dir = std::make_shared<std::string>();
  auto as_json = std::make_shared<bool>(false);
  auto times = std::make_shared<bool>(false);
  sub->add_option("dir", *dir, "folder of results")->required();
  sub->add_flag("--times", *times, "what a run of each system costs, and all of them");
  sub->add_flag("--json", *as_json, "as one line of JSON");
  sub->callback([=, &action] { action = [=] { return status(*dir, *as_json, *times); }; });
}

}  // namespace jam::app
