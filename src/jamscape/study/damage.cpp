#include "jamscape/study/damage.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "jamscape/base/error.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/base/threads.hpp"

namespace jam {

bool may_write_results(const std::filesystem::path& results, const std::vector<Task>& tasks) {
  const auto denied = [](const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::exists(path, ignored) && !may_write(path);
  };
  return !denied(results) && !denied(results / "tables") && !denied(results / "ensemble") &&
         std::none_of(tasks.begin(), tasks.end(), [&](const Task& task) {
           const TaskFolder folder(results, task.hash);
           return denied(folder.path()) || denied(folder.tables());
         });
}

bool is_left_out(const std::vector<LeftOut>& left_out, const std::string& hash) {
  return std::any_of(left_out.begin(), left_out.end(), [&](const LeftOut& l) { return l.hash == hash; });
}

std::string describe(const LeftOut& left_out, const Study& study, const std::vector<Task>& tasks) {
  for (const Task& task : tasks)
    if (task.hash == left_out.hash)
      return fmt::format("{} {} is left out: {}", study.systems[task.system].name, task.realisation + 1,
                         left_out.reason);
  return left_out.reason;
}

std::vector<LeftOut> find_damage(const std::vector<Task>& tasks, const std::filesystem::path& results, int jobs) {
  const std::vector<std::size_t> order = order_tasks(tasks, {});
  std::vector<std::string> reasons(order.size());
  run_jobs(order.size(), jobs, [&](std::size_t k) {
    if (const auto stored = check_stored(TaskFolder(results, tasks[order[k]].hash))) reasons[k] = stored->reason;
  });
  std::vector<LeftOut> left_out;
  for (std::size_t k = 0; k < order.size(); ++k)
    if (!reasons[k].empty()) left_out.push_back({tasks[order[k]].hash, reasons[k]});
  return left_out;
}

std::string damaged_content(const TaskFolder& folder) try {
  const RunFile run(folder.run_file(), Look::structure);
  for (std::size_t k = 0; k < run.frames(); ++k) run.frame(k);
  return {};
} catch (const Error& error) {
  return error.what();
}

}  // namespace jam
