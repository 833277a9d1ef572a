// Is a simulation still what it was? Run it again and compare every bit of every frame.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "jamscape/study/study.hpp"
#include "jamscape/study/task.hpp"

namespace jam {

/// Simulates a task that is done again, in a folder of its own that is removed afterwards, and compares. Returns "" or
/// what differs where, or nothing when `stop` asked for an end. Throws a data error for a task that is not done, or
/// whose run.h5 is damaged.
std::optional<std::string> verify_task(const Study& study, const Task& task, const std::filesystem::path& results,
                                       const std::function<void(const Progress&)>& progress = {},
                                       const std::function<bool()>& stop = {});

}  // namespace jam
