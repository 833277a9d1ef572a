// What the runs of a study have cost, system by system, and what those still to come will.
#pragma once

#include <filesystem>
#include <vector>

#include "jamscape/study/task.hpp"

namespace jam::app {

void print_times(const std::filesystem::path& results, const Study& study, const std::vector<Task>& tasks);

}  // namespace jam::app
