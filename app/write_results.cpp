#include "write_results.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "jamscape/report/report.hpp"
#include "jamscape/study/tables.hpp"

namespace jam::app {

void write_results(const Study& study, const std::vector<Task>& tasks, const std::filesystem::path& results, Summary summary) {
  write_tables(study, tasks, results);
  write_report(results);
  if (summary == Summary::text) fmt::print("report: {}\n", (results / "report.html").string());
}

}  // namespace jam::app
