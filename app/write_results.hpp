// From finished tasks to tables, ensemble means, report and a few lines for people.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "jamscape/study/damage.hpp"
#include "jamscape/study/study.hpp"
#include "jamscape/study/task.hpp"

namespace jam::app {

enum class Summary { text, json, none };

/// What write_results() reads, and where it writes.
struct Written {
  ResultPlaces places;
  std::filesystem::path to;       ///< the folder of tables/, ensemble/ and report.html
  std::vector<LeftOut> left_out;  ///< runs that cannot be used
  bool keeps = true;              ///< false for a folder that is gone afterwards: no path is printed
};

struct Warned {
  std::size_t not_relaxed = 0;  ///< frames
  std::size_t marked = 0;       ///< frames whose energy ledger is off (study/ledger.hpp)
  bool damaged = false;         ///< runs were left out
};

/// Writes tables, ensemble and report, prints what was found, and names on standard error the runs that are left out
/// and the frames that are not relaxed or marked.
Warned write_results(const Study& study, const std::vector<Task>& tasks, const Written& written, Summary summary);

/// Names runs that cannot be used on standard error; true when there are some.
bool name_left_out(const std::vector<LeftOut>& left_out, const Study& study, const std::vector<Task>& tasks);

}  // namespace jam::app
