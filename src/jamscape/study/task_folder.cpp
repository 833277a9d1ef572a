#include "jamscape/study/task_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "jamscape/base/error.hpp"
#include "jamscape/base/files.hpp"

namespace jam {

namespace fs = std::filesystem;

namespace {

fs::path free_name(const fs::path& before, const std::string& after) {
  std::error_code ignored;
  for (int k = 1;; ++k)
    if (fs::path name = before.string() + std::to_string(k) + after; !fs::exists(name, ignored)) return name;
}

}  // namespace

fs::path TaskFolder::frame(std::size_t index) const { return frames() / fmt::format("{:06}.h5", index); }

TaskState TaskFolder::state() const {
  std::error_code ignored;
  if (fs::exists(path_ / "failed.txt", ignored)) return TaskState::failed;
  if (fs::exists(run_file(), ignored)) return TaskState::done;
  return fs::exists(path_ / "task.toml", ignored) ? TaskState::started : TaskState::waiting;
}

std::string TaskFolder::failure() const {
  std::error_code ignored;
  if (!fs::exists(path_ / "failed.txt", ignored)) return {};
  std::string text = read_text(path_ / "failed.txt");
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

void TaskFolder::log(const std::string& json_line) const noexcept {
  try {
    std::ofstream(path_ / "log.jsonl", std::ios::app) << json_line << '\n';
  } catch (...) {
  }
}

void TaskFolder::discard_partial() const {
  std::error_code ignored;
  fs::remove(checkpoint(), ignored);
  fs::remove_all(frames(), ignored);
}

fs::path TaskFolder::set_aside_frames() const {
  std::error_code ignored;
  const fs::path aside = free_name(path_ / "frames.damaged-", "");
  fs::rename(frames(), aside);
  fs::remove(checkpoint(), ignored);
  return aside;
}

fs::path TaskFolder::set_aside_run() const {
  const fs::path aside = free_name(path_ / "run.damaged-", ".h5");
  std::error_code error;
  fs::rename(run_file(), aside, error);
  if (error) throw data_error("cannot rename the damaged file: " + error.message(), run_file().string());
  return aside;
}

std::optional<std::vector<std::size_t>> stored_frames(const RunFile& run, const Plan& plan) {
  const std::vector<std::int64_t>& steps = run.steps();
  const std::vector<std::string>&stages = run.stages(), &relaxations = run.relaxations();
  const std::vector<double>& fractions = run.packing_fractions();
  std::vector<std::size_t> indices;
  std::vector<bool> taken(steps.size(), false);  // of the frames whose steps were not known before
  for (const PlannedFrame& wanted : plan.frames) {
    const auto better = [&](std::size_t a, std::size_t b) {
      if (wanted.step >= 0) return stages[a] == wanted.stage && stages[b] != wanted.stage;
      return std::abs(fractions[a] - wanted.packing_fraction) < std::abs(fractions[b] - wanted.packing_fraction);
    };
    std::optional<std::size_t> found;
    for (std::size_t k = 0; k < steps.size(); ++k)
      if (!taken[k] && wanted.matches(steps[k], stages[k], fractions[k], relaxations[k]) &&
          (!found || better(k, *found)))
        found = k;
    if (!found) return std::nullopt;
    taken[*found] = wanted.step < 0;
    indices.push_back(*found);
  }
  return indices;
}

std::optional<RunCheck> check_stored(const TaskFolder& folder) {
  std::error_code ignored;
  if (!fs::exists(folder.run_file(), ignored)) return {};
  return check_run(folder.run_file());
}

bool has_all_frames(const TaskFolder& folder, const Plan& plan) {
  std::error_code ignored;
  if (!fs::exists(folder.run_file(), ignored)) return false;
  try {
    return stored_frames(RunFile(folder.run_file(), Look::structure), plan).has_value();
  } catch (const Error&) {
    return false;
  }
}

}  // namespace jam
