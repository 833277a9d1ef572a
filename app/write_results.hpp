// From finished tasks to tables, ensemble means, report and a few lines for people.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "jamscape/study/study.hpp"
#include "jamscape/study/task.hpp"

namespace jam::app {

enum class Summary { text, json, none };

/// Writes DIR/tables, DIR/ensemble and DIR/report.html, prints what was found, and warns on standard error of frames
/// that are not relaxed; returns how many they are.
std::size_t write_results(const Study& study, const std::vector<Task>& tasks, const std::filesystem::path& results,
                          Summary summary);

}  // namespace jam::app
