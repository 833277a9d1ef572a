#include "jamscape/study/plan_file.hpp"

#include <fmt/format.h>

#include <cmath>

#include "jamscape/base/error.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/base/hash.hpp"
#include "jamscape/io/csv.hpp"
#include "jamscape/study/study.hpp"

namespace jam {
namespace {

namespace fs = std::filesystem;

/// Of all options of the system, those of its stages and their frames included.
std::string key_of(SystemOptions system) {
  std::string text;
  for (const Option& option : system_options(system)) text += option.key + " = " + print_value(option) + "\n";
  return short_hash("jamscape plan\n" + text);
}

std::string text_of(const SystemOptions& system, const Plan& plan) {
  Table table;
  std::vector<std::string> stage;
  std::vector<double> fraction;
  std::vector<std::int64_t> step, relaxed;
  for (const PlannedFrame& f : plan.frames) {
    stage.push_back(f.stage), fraction.push_back(f.packing_fraction);
    step.push_back(f.step), relaxed.push_back(f.relaxed);
  }
  table.add("stage", std::move(stage));
  table.add("packing_fraction", std::move(fraction));
  table.add("step", std::move(step));
  table.add("relaxed", std::move(relaxed));
  const std::string rows = to_csv(table, {{"steps", fmt::format("{}", plan.steps)},
                                          {"bodies", fmt::format("{}", plan.bodies)},
                                          {"start", fmt::format("{}", plan.start)}});
  return fmt::format("# key: {}\n# sum: {}\n{}", key_of(system), short_hash(rows), rows);
}

std::string value_of(const CsvMetadata& lines, std::string_view key) {
  for (const auto& [name, value] : lines)
    if (name == key) return value;
  throw data_error(fmt::format("the plan has no line '# {}'", key));
}

}  // namespace

void write_plan(const TaskFolder& folder, const SystemOptions& system, const Plan& plan) {
  const std::string text = text_of(system, plan);
  std::error_code ignored;
  if (!fs::exists(folder.plan(), ignored) || read_text(folder.plan()) != text) write_text(folder.plan(), text);
}

std::optional<Plan> read_plan(const TaskFolder& folder, const SystemOptions& system) try {
  std::error_code ignored;
  if (!fs::exists(folder.plan(), ignored)) return std::nullopt;
  const std::string text = read_text(folder.plan());
  const CsvFile csv = CsvFile::parse(text, folder.plan().string());
  const CsvMetadata lines = csv.metadata();
  Plan plan;
  plan.axis = plans_packing_fraction(system) ? &planned_packing_fraction : &reached_packing_fraction;
  plan.steps = std::stoll(value_of(lines, "steps"));
  plan.bodies = std::stoll(value_of(lines, "bodies"));
  plan.start = std::stod(value_of(lines, "start"));
  const Table table = csv.table();
  const std::vector<double> fraction = table.numbers("packing_fraction"), step = table.numbers("step"),
                            relaxed = table.numbers("relaxed");
  for (std::size_t k = 0; k < csv.rows(); ++k)
    plan.frames.push_back(
        {std::string(csv.field(k, 0)), fraction[k], static_cast<std::int64_t>(step[k]), relaxed[k] != 0});
  if (text_of(system, plan) != text) return std::nullopt;  // of other options, cut short, or changed
  return plan;
} catch (const std::exception&) {
  return std::nullopt;  // a list that cannot be read is made anew
}

}  // namespace jam
