#include "jamscape/study/measure_task.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "jamscape/base/error.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/base/hash.hpp"
#include "jamscape/base/threads.hpp"
#include "jamscape/study/version.hpp"

namespace jam {
namespace {

namespace fs = std::filesystem;

std::string measure_key(const Measure& measure, MeasureOptions options, const RunFile& run) {
  std::string text = fmt::format("{} {}\n{}\n", program_version(), measure.name, measure.formula);
  for (const ColumnInfo& c : measure.columns) text += c.name + "\n";
  for (const Option& o : options_of(options)) text += fmt::format("{} = {}\n", o.key, print_value(o));
  for (const std::int64_t step : run.steps()) text += fmt::format("{} ", step);
  return short_hash(text);
}

fs::path table_file(const TaskFolder& folder, const Measure& measure) {
  return folder.tables() / (measure.name + ".csv");
}

nlohmann::json read_keys(const TaskFolder& folder) {
  std::error_code ignored;
  const fs::path file = folder.tables() / "keys.json";
  if (!fs::exists(file, ignored)) return nlohmann::json::object();
  nlohmann::json keys = nlohmann::json::parse(read_text(file), nullptr, false);
  return keys.is_object() ? keys : nlohmann::json::object();
}

/// A member that is text, or "".
std::string text_at(const nlohmann::json& object, const std::string& name) {
  const auto at = object.is_object() ? object.find(name) : object.end();
  return at != object.end() && at->is_string() ? at->get<std::string>() : std::string();
}

constexpr const char* sums = "sums";  // of the tables' bytes, by measure

enum class Kept { absent, whole, damaged };

/// Tables written before there were sums count as whole.
Kept kept_rows(const TaskFolder& folder, const Measure& measure, const nlohmann::json& keys, const std::string& key) {
  std::error_code ignored;
  const fs::path file = table_file(folder, measure);
  if (!fs::exists(file, ignored) || text_at(keys, measure.name) != key) return Kept::absent;
  const std::string sum = text_at(keys.value(sums, nlohmann::json::object()), measure.name);
  return sum.empty() || sum == short_hash(read_text(file)) ? Kept::whole : Kept::damaged;
}

/// Those whose rows are not kept, or not whole.
std::vector<const Measure*> missing_rows(const TaskFolder& folder, const std::vector<const Measure*>& measures,
                                         const MeasureOptions& options, const RunFile& run) {
  const nlohmann::json keys = read_keys(folder);
  std::vector<const Measure*> missing;
  for (const Measure* m : measures)
    if (kept_rows(folder, *m, keys, measure_key(*m, options, run)) != Kept::whole) missing.push_back(m);
  return missing;
}

std::string header(const Measure& measure) {
  std::string text = "frame";
  for (const ColumnInfo& c : measure.columns) text += "," + c.name;
  return text + "\n";
}

void append_rows(const Measure& measure, const Table& table, std::size_t frame, std::string& text) {
  std::vector<const Column*> columns;
  for (const ColumnInfo& c : measure.columns) columns.push_back(&table.column(c.name));
  for (std::size_t row = 0; row < table.rows(); ++row) {
    text += fmt::format("{}", frame);
    for (const Column* column : columns)
      std::visit([&](const auto& values) { text += fmt::format(",{}", values[row]); }, column->values);
    text += "\n";
  }
}

}  // namespace

std::vector<const Measure*> chosen_measures(const Study& study) {
  std::vector<const Measure*> chosen;
  for (const std::string& name : study.measures.list) find_measure(name);
  for (const Measure& m : measures()) {
    const std::vector<std::string>& list = study.measures.list;
    if (list.empty() || std::find(list.begin(), list.end(), m.name) != list.end()) chosen.push_back(&m);
  }
  return chosen;
}

const Measure& instant_measure() {
  static const Measure measure{
      .name = "instant",
      .title = "step, time and packing fraction",
      .formula = "",
      .source = "",
      .columns = {{"step", "", ""}, {"time", "", ""}, {"packing_fraction", "", ""}, {"packing_fraction_plain", "", ""}},
      .evaluate = [](const Snapshot& snapshot) {
        const Packing& p = snapshot.packing();
        Table table;
        table.add("step", std::vector<std::int64_t>{p.step});
        table.add("time", std::vector<double>{p.time});
        table.add("packing_fraction", std::vector<double>{p.packing_fraction});
        table.add("packing_fraction_plain", std::vector<double>{p.packing_fraction_plain});
        return table;
      }};
  return measure;
}

const Measure& ledger_measure() {
  static const Measure measure{.name = "ledger",
                               .title = "energy ledger",
                               .formula = "",
                               .source = "",
                               .columns = {{"ledger_sum", "", ""}, {"turned_over", "", ""}},
                               .evaluate = [](const Snapshot& snapshot) {
                                 const EnergyLedger& e = snapshot.packing().energy;
                                 Table table;
                                 table.add("ledger_sum", std::vector<double>{e.sum()});
                                 table.add("turned_over", std::vector<double>{e.turned_over()});
                                 return table;
                               }};
  return measure;
}

const Measure& ledger_error_measure() {
  static const Measure measure{.name = "ledger_error",
                               .title = "how far the ledger is off",
                               .formula = "",
                               .source = "",
                               .columns = {{"ledger_error", "", ""}},
                               .evaluate = {}};
  return measure;
}

const Measure& relaxation_measure() {
  static const Measure measure{.name = "relaxation",
                               .title = "what ended the relaxation",
                               .formula = "",
                               .source = "",
                               .columns = {{"relaxation", "", ""}},
                               .evaluate = [](const Snapshot& snapshot) {
                                 Table table;
                                 table.add("relaxation", std::vector<std::string>{snapshot.packing().relaxation});
                                 return table;
                               }};
  return measure;
}

MeasureOptions measure_options(const Study& study, std::size_t system) {
  MeasureOptions options = study.measure;
  options.gravity = study.systems[system].options.domain.gravity;
  return options;
}

std::size_t measure_task(const TaskFolder& folder, const std::vector<const Measure*>& wanted,
                         const MeasureOptions& options, Remeasure what, const std::function<bool()>& stop) {
  std::vector<const Measure*> measures = {&instant_measure(), &ledger_measure()};
  measures.insert(measures.end(), wanted.begin(), wanted.end());
  const RunFile run(folder.run_file(), Look::structure);
  const auto relaxed = [](const std::string& relaxation) { return !relaxation.empty(); };
  if (std::any_of(run.relaxations().begin(), run.relaxations().end(), relaxed))
    measures.push_back(&relaxation_measure());
  const std::vector<const Measure*> missing =
      what == Remeasure::all ? measures : missing_rows(folder, measures, options, run);
  if (missing.empty()) return 0;

  std::vector<std::string> texts;
  for (const Measure* m : missing) texts.push_back(header(*m));
  SnapshotMemory memory;
  for (std::size_t frame = 0; frame < run.frames(); ++frame) {
    if (stop && stop()) return 0;
    const Packing packing = run.frame(frame);
    const Snapshot snapshot(packing, options, &memory);
    for (std::size_t k = 0; k < missing.size(); ++k)
      append_rows(*missing[k], missing[k]->evaluate(snapshot), frame, texts[k]);
  }
  make_folder(folder.tables());
  nlohmann::json keys = read_keys(folder);
  if (!keys.contains(sums) || !keys[sums].is_object()) keys[sums] = nlohmann::json::object();
  for (std::size_t k = 0; k < missing.size(); ++k) {
    write_text(table_file(folder, *missing[k]), texts[k]);
    keys[missing[k]->name] = measure_key(*missing[k], options, run);
    keys[sums][missing[k]->name] = short_hash(texts[k]);
  }
  write_text(folder.tables() / "keys.json", keys.dump(1) + "\n");
  return missing.size();
}

bool has_rows(const TaskFolder& folder, const std::vector<const Measure*>& measures) {
  const auto there = [&](const Measure* m) {
    std::error_code ignored;
    return fs::exists(table_file(folder, *m), ignored);
  };
  return there(&instant_measure()) && std::all_of(measures.begin(), measures.end(), there);
}

std::vector<LeftOut> measure_tasks(const Study& study, const std::vector<Task>& tasks, const ResultPlaces& places,
                                   int jobs, Remeasure what) {
  const std::vector<const Measure*> chosen = chosen_measures(study);
  const std::vector<std::size_t> order = order_tasks(tasks, {});
  std::vector<std::string> reasons(order.size());
  run_jobs(order.size(), jobs, [&](std::size_t k) {
    const Task& task = tasks[order[k]];
    const TaskFolder folder(places.results, task.hash);
    const auto stored = check_stored(folder);
    if (!stored) return;
    reasons[k] = stored->reason;
    if (!stored->usable() || !has_all_frames(folder, task.plan)) return;
    try {
      if (places.rows == places.results) {
        if (const auto lock = FileLock::try_lock(folder.lock()))
          measure_task(folder, chosen, measure_options(study, task.system), what);
        return;
      }
      std::vector<const Measure*> wanted = {&instant_measure(), &ledger_measure()};
      wanted.insert(wanted.end(), chosen.begin(), chosen.end());
      const TaskFolder elsewhere(places.results, task.hash, places.rows);
      if (what == Remeasure::all || !missing_rows(folder, wanted, measure_options(study, task.system),
                                                  RunFile(folder.run_file(), Look::structure))
                                         .empty())
        measure_task(elsewhere, chosen, measure_options(study, task.system), what);
      else
        fs::remove_all(elsewhere.tables());  // of an earlier time; the results have their own
    } catch (const Error& error) {
      if (const std::string damage = damaged_content(folder); !damage.empty())
        reasons[k] = damage;
      else
        throw;
    }
  });
  std::vector<LeftOut> left_out;
  for (std::size_t k = 0; k < order.size(); ++k)
    if (!reasons[k].empty()) left_out.push_back({tasks[order[k]].hash, reasons[k]});
  return left_out;
}

CachedRows read_cached_rows(const TaskFolder& folder, const Measure& measure) {
  const fs::path file = table_file(folder, measure);
  const std::string text = read_text(file);
  CachedRows rows;
  std::size_t at = 0;
  for (bool first = true; at < text.size(); first = false) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line(text.data() + at, end - at);
    at = end + 1;
    const std::size_t comma = line.find(',');
    if (comma == std::string_view::npos) throw data_error("a line has no columns", file.string());
    if (first) {
      rows.header = line.substr(comma + 1);
      continue;
    }
    std::size_t frame = 0;
    if (std::from_chars(line.data(), line.data() + comma, frame).ptr != line.data() + comma || frame > 100'000'000)
      throw data_error("a line begins with no frame", file.string(), "remove the file; it will be made anew");
    if (rows.lines.size() <= frame) rows.lines.resize(frame + 1);
    rows.lines[frame].emplace_back(line.substr(comma + 1));
  }
  return rows;
}

std::vector<double> read_numbers(std::string_view line, const std::string& file) {
  std::vector<double> numbers;
  const char *at = line.data(), *end = at + line.size();
  while (true) {
    double value = 0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc{} || (next != end && *next != ','))
      throw data_error(fmt::format("\"{}\" is no line of numbers", line), file,
                       "remove the file; it will be made anew");
    numbers.push_back(value);
    if (next == end) return numbers;
    at = next + 1;
  }
}

}  // namespace jam
