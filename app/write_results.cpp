#include "write_results.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "jamscape/report/report.hpp"

namespace jam::app {

void write_results(const Study& study, const std::vector<Task>& tasks, const std::filesystem::path& results, Summary summary) {
  static_cast<void>(study), static_cast<void>(tasks), static_cast<void>(summary);
  write_report(results);
}

}  // namespace jam::app
