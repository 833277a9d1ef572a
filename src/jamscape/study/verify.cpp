#include "jamscape/study/verify.hpp"

#include <fmt/format.h>

#include "jamscape/base/error.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/packing/difference.hpp"
#include "jamscape/study/simulate_task.hpp"
#include "jamscape/study/task_folder.hpp"

namespace jam {
namespace {

namespace fs = std::filesystem;

}  // namespace

std::optional<std::string> verify_task(const Study& study, const Task& task, const fs::path& results,
                                       const std::function<void(const Progress&)>& progress,
                                       const std::function<bool()>& stop) {
  const TaskFolder stored(results, task.hash);
  if (!has_all_frames(stored, task.plan))
    throw data_error("the task is not done, so there is nothing to compare with", stored.path().string(),
                     "jamscape run");
  const RunFile before(stored.run_file());
  const ScratchFolder scratch("verify");
  const TaskFolder again(scratch.path(), task.hash);
  if (simulate_task(study, task, again, {progress, stop, {}, 1e9}) == Outcome::stopped) return std::nullopt;
  const RunFile after(again.run_file());
  const std::vector<std::size_t> at_before = stored_frames(before, task.plan).value(),
                                 at_after = stored_frames(after, task.plan).value();
  for (std::size_t f = 0; f < at_before.size(); ++f) {
    const std::string difference = first_difference(before.frame(at_before[f]), after.frame(at_after[f]));
    if (!difference.empty()) return fmt::format("frame {} differs in {}", f, difference);
  }
  return std::string();
}

}  // namespace jam
