#include "status_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "jamscape/base/cores.hpp"
#include "jamscape/base/progress.hpp"
#include "jamscape/study/time_spent.hpp"

namespace jam::app {
namespace {

/// Sums over the finished runs of a system.
struct Cost {
  std::size_t runs = 0, finished = 0;
  double grains = 0, steps = 0, grain_steps = 0, seconds = 0;
};

Cost cost_of(const std::filesystem::path& results, const std::vector<Task>& tasks, std::size_t system) {
  Cost cost;
  for (const Task& task : tasks) {
    if (task.system != system) continue;
    ++cost.runs;
    const TimeSpent spent = time_spent(TaskFolder(results, task.hash));
    if (!spent.finished) continue;
    ++cost.finished;
    cost.grains += static_cast<double>(spent.bodies);
    cost.steps += static_cast<double>(spent.steps);
    cost.grain_steps += static_cast<double>(spent.bodies) * static_cast<double>(spent.steps);
    cost.seconds += spent.core_seconds;
  }
  return cost;
}

}  // namespace

void print_times(const std::filesystem::path& results, const Study& study, const std::vector<Task>& tasks) {
  std::size_t width = 6;
  for (const System& system : study.systems) width = std::max(width, system.name.size());
  fmt::print("{:{}}  runs done  grains     steps  core time a run  million grain-steps/s  all runs of the study\n",
             "system", width);
  double spent = 0, whole = 0;
  bool known = true;
  for (std::size_t s = 0; s < study.systems.size(); ++s) {
    const Cost c = cost_of(results, tasks, s);
    const std::string done = fmt::format("{} of {}", c.finished, c.runs);
    if (c.finished == 0) {
      fmt::print("{:{}}  {:>9}\n", study.systems[s].name, width, done);
      known = false;
      continue;
    }
    const double n = static_cast<double>(c.finished), all = c.seconds / n * static_cast<double>(c.runs);
    fmt::print("{:{}}  {:>9}  {:6.0f}  {:8.3g}  {:>15}  {:21.1f}  {:>21}\n", study.systems[s].name, width, done,
               c.grains / n, c.steps / n, print_duration(c.seconds / n), c.grain_steps / c.seconds / 1e6,
               print_duration(all));
    spent += c.seconds, whole += all;
  }
  const int cores = usable_cores();
  fmt::print("core time spent on finished runs: {}", print_duration(spent));
  if (known)
    fmt::print("; the whole study: {}, {} on {} cores", print_duration(whole), print_duration(whole / cores), cores);
  fmt::print("\n");
}

}  // namespace jam::app
