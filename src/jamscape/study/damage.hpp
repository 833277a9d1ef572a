// One rule for damage, whatever is done with results: name it, go on with the others, end with an exit code that says
// so; `run` simulates the task again.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "jamscape/study/study.hpp"
#include "jamscape/study/task.hpp"
#include "jamscape/study/task_folder.hpp"

namespace jam {

/// A run that cannot be used.
struct LeftOut {
  std::string hash, reason;
};

/// Where results are read, and where the rows of the measures go that they lack: the same folder, or another when
/// nothing can be written there.
struct ResultPlaces {
  std::filesystem::path results, rows;
  explicit ResultPlaces(const std::filesystem::path& folder) : results(folder), rows(folder) {}
  ResultPlaces(std::filesystem::path from, std::filesystem::path to) : results(std::move(from)), rows(std::move(to)) {}
};

/// True when rows can be kept with the results: nothing there is read-only or somebody else's.
bool may_write_results(const std::filesystem::path& results, const std::vector<Task>& tasks);

bool is_left_out(const std::vector<LeftOut>& left_out, const std::string& hash);

/// The task's system and realisation, what is wrong, and what becomes of it.
std::string describe(const LeftOut& left_out, const Study& study, const std::vector<Task>& tasks);

/// Looks at every byte of the run files of these tasks, several at a time, and returns those that cannot be used.
std::vector<LeftOut> find_damage(const std::vector<Task>& tasks, const std::filesystem::path& results, int jobs);

/// Reads every frame of a run that has no seal, or whose seal was looked at before; why that fails, or "".
std::string damaged_content(const TaskFolder& folder);

}  // namespace jam
