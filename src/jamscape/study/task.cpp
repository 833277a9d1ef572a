#include "jamscape/study/task.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "jamscape/base/error.hpp"
#include "jamscape/base/nearest.hpp"
#include "jamscape/protocol/start.hpp"
#include "jamscape/study/identity.hpp"

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

}  // namespace

std::vector<Task> list_tasks(const Study& study) {
  std::vector<Task> tasks;
  const auto seed = static_cast<std::uint64_t>(study.info.seed);
  for (std::size_t s = 0; s < study.systems.size(); ++s) {
    const System& system = study.systems[s];
    for (std::int64_t r = 0; r < study.info.realisations; ++r) {
      Task task;
      task.system = s;
      task.realisation = static_cast<std::uint64_t>(r);
      task.key = task_key(system.options, seed, task.realisation);
      task.hash = task_hash(system.options, seed, task.realisation);
      try {
        if (r == 0) check_start(system.options);
        task.plan = plan(system.options, task.key);
      } catch (const Error& error) {
        throw with_place(error, system, study.file);
      }
      tasks.push_back(std::move(task));
    }
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
