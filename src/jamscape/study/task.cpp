#include "jamscape/study/task.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "jamscape/base/error.hpp"
#include "jamscape/base/nearest.hpp"
#include "jamscape/protocol/start.hpp"
#include "jamscape/study/collected.hpp"
#include "jamscape/study/identity.hpp"
#include "jamscape/study/plan_file.hpp"

namespace jam {
namespace {

/// The engine names the option a complaint is about; here it gets the place where that option was written.
Error with_place(const Error& error, const System& system, const std::string& file) {
  if (!error.place().empty()) return error;
  std::string key, place = file;
  for (const auto& [name, at] : system.places)
    if (name.size() > key.size() && error.problem().find(name) != std::string::npos) key = name, place = at;
  return {error.code(), fmt::format("system '{}': {}", system.name, error.problem()), place, error.suggestion()};
}

/// Tasks within a quarter of each other count as equally long.
int cost_class(const Task& task) {
  return static_cast<int>(std::floor(std::log(std::max(1.0, task.cost())) / std::log(1.25)));
}

/// Named, not planned.
std::vector<Task> name_tasks(const Study& study) {
  std::vector<Task> tasks;
  const auto seed = static_cast<std::uint64_t>(study.info.seed);
  for (std::size_t s = 0; s < study.systems.size(); ++s) {
    const SystemOptions& options = study.systems[s].options;
    for (std::uint64_t r = 0; r < static_cast<std::uint64_t>(study.info.realisations); ++r)
      tasks.push_back({s, r, task_key(options, seed, r), task_hash(options, seed, r), {}});
  }
  return tasks;
}

/// Fills in the plan.
void plan_task(const Study& study, Task& task) {
  const System& system = study.systems[task.system];
  try {
    if (task.realisation == 0) check_start(system.options);
    task.plan = plan(system.options, task.key);
  } catch (const Error& error) {
    throw with_place(error, system, study.file);
  }
}

}  // namespace

std::vector<Task> plan_tasks(const Study& study) {
  std::vector<Task> tasks = name_tasks(study);
  for (Task& task : tasks) plan_task(study, task);
  return tasks;
}

std::vector<Task> stored_tasks(const Study& study, const std::filesystem::path& results) {
  std::vector<Task> tasks = name_tasks(study);
  if (is_collected(results)) return tasks;  // the tables name their frames
  for (Task& task : tasks) {
    if (auto known = read_plan(TaskFolder(results, task.hash), study.systems[task.system].options))
      task.plan = std::move(*known);
    else
      plan_task(study, task);
  }
  return tasks;
}

std::vector<Task> tasks_of(const Study& study, const std::vector<Task>& tasks,
                           const std::vector<std::string>& systems) {
  std::vector<std::string> known;
  for (const System& system : study.systems) known.push_back(system.name);
  const auto has = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const std::string& name : systems) {
    if (has(known, name)) continue;
    const std::string near = nearest(name, known);
    throw usage_error(fmt::format("the study has no system '{}'", name), study.file,
                      near.empty() ? fmt::format("its systems: {}", fmt::join(known, ", "))
                                   : fmt::format("did you mean '{}'?", near));
  }
  std::vector<Task> chosen;
  for (const Task& task : tasks)
    if (has(systems, known[task.system])) chosen.push_back(task);
  return chosen;
}

Shard read_shard(const std::string& text) {
  Shard shard;
  const char *at = text.data(), *end = at + text.size();
  const auto first = std::from_chars(at, end, shard.index);
  const bool slash = first.ec == std::errc{} && first.ptr != end && *first.ptr == '/';
  const auto second = slash ? std::from_chars(first.ptr + 1, end, shard.count) : first;
  if (!slash || second.ec != std::errc{} || second.ptr != end || shard.index < 1 || shard.index > shard.count)
    throw usage_error(fmt::format("'{}' is no shard", text), "--shard",
                      "i/n with 1 <= i <= n, for example --shard 1/4");
  return shard;
}

std::vector<std::size_t> order_tasks(const std::vector<Task>& tasks, const Shard& shard) {
  std::vector<std::size_t> order;
  std::set<std::string> seen;
  for (std::size_t k = 0; k < tasks.size(); ++k)
    if (seen.insert(tasks[k].hash).second) order.push_back(k);
  const auto rank = [&](std::size_t k) { return std::pair(-cost_class(tasks[k]), tasks[k].realisation); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  std::vector<std::size_t> mine;
  for (std::size_t k = 0; k < order.size(); ++k)
    if (k % static_cast<std::size_t>(shard.count) == static_cast<std::size_t>(shard.index - 1))
      mine.push_back(order[k]);
  return mine;
}

}  // namespace jam
