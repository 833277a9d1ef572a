#include "jamscape/observe/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "commands.hpp"
#include "complain.hpp"
#include "jamscape/base/cores.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/io/column_names.hpp"
#include "jamscape/io/csv.hpp"
#include "jamscape/io/network_file.hpp"
#include "jamscape/io/packing_csv.hpp"
#include "jamscape/io/run_file.hpp"
#include "jamscape/study/measure_task.hpp"
#include "jamscape/study/results.hpp"
#include "jamscape/topology/bins.hpp"
#include "jamscape/topology/total.hpp"
#include "normalise.hpp"
#include "write_results.hpp"

namespace jam::app {
namespace {

namespace fs = std::filesystem;

struct MeasureArguments {
  std::vector<std::string> files, settings, names;
  std::string out;
  bool again = false;
};

Study with_settings(Study study, const MeasureArguments& a) {
  std::vector<Setting> settings;
  for (const std::string& text : a.settings) {
    settings.push_back(read_setting(text));
    if (!settings.back().key.starts_with("measure."))
      throw usage_error(fmt::format("'{}' is no option of the measures", settings.back().key), "--set",
                        "only measure.* can change without simulating again");
  }
  study = read_study_text(print_study(study), "the study", settings);
  for (const std::string& name : a.names) find_measure(name);
  return study;
}

ExitCode measure_results(const MeasureArguments& a) {
  const fs::path dir = a.files.front();
  Study study = with_settings(study_of_results(dir), a);
  if (!a.names.empty() && !study.measures.list.empty())
    for (const std::string& name : a.names)
      if (std::find(study.measures.list.begin(), study.measures.list.end(), name) == study.measures.list.end())
        study.measures.list.push_back(name);
  chosen_measures(study);
  const std::vector<Task> tasks = list_tasks(study);
  std::optional<ScratchFolder> scratch;
  if (may_write_results(dir, tasks)) {
    write_results_study(dir, study);
  } else {
    complain("note: nothing can be written into {}: its tables and report stay as they are\n", dir.string());
    scratch.emplace("measure");
    write_study(scratch->path(), study);
  }
  const ResultPlaces places(dir, scratch ? scratch->path() : dir);
  const std::vector<LeftOut> left_out =
      measure_tasks(study, tasks, places, usable_cores(), a.again ? Remeasure::all : Remeasure::missing);
  const bool damaged = write_results(study, tasks, {places, places.rows, left_out, !scratch}, Summary::text).damaged;
  return damaged ? ExitCode::data : ExitCode::done;
}

/// Adds the rows of `part` below those of `whole`; an empty whole takes the columns of the part.
void append(Table& whole, const Table& part) {
  if (whole.columns.empty()) {
    whole = part;
    return;
  }
  for (std::size_t c = 0; c < part.columns.size(); ++c)
    std::visit(
        [&](auto& values) {
          const auto& more = std::get<std::decay_t<decltype(values)>>(part.columns[c].values);
          values.insert(values.end(), more.begin(), more.end());
        },
        whole.columns[c].values);
}

/// The measures of one row a frame side by side, or one measure of several rows.
Table measure_packing(const Packing& packing, const MeasureOptions& options, const std::vector<std::string>& names) {
  const Snapshot snapshot(packing, options);
  if (names.size() == 1 && find_measure(names.front()).rows == Rows::many)
    return find_measure(names.front()).evaluate(snapshot);
  Table row;
  row.add("packing_fraction", std::vector<double>{packing.packing_fraction});
  for (const Measure& m : measures()) {
    const bool wanted = names.empty() || std::find(names.begin(), names.end(), m.name) != names.end();
    if (!wanted) continue;
    if (m.rows == Rows::many) {
      if (names.empty()) continue;
      throw usage_error(fmt::format("'{}' gives a table of its own", m.name), "--measure", "ask for it alone");
    }
    for (Column& c : m.evaluate(snapshot).columns) row.columns.push_back(std::move(c));
  }
  return row;
}

Table measure_network(const fs::path& file, const MeasureOptions& options) {
  NamedGraph network = read_network(file);
  const double mean = normalise(network.graph);
  if (options.clamp > 0) clamp(network.graph, options.clamp);
  const Diagram diagram = persistence(network.graph);
  Table row;
  const auto count = [&](const char* name, std::size_t n) {
    row.add(name, std::vector<std::int64_t>{static_cast<std::int64_t>(n)});
  };
  count("vertices", network.graph.vertices);
  count("edges", network.graph.edges());
  row.add("mean_force", std::vector<double>{mean});
  row.add("z", std::vector<double>{2 * static_cast<double>(network.graph.edges()) / network.graph.vertices});
  for (const int k : {0, 1}) {
    const BinCounts b = persistence_bins(diagram, k);
    count(k == 0 ? "b0_rough" : "b1_rough", b.rough);
    count(k == 0 ? "b0_strong" : "b1_strong", b.strong);
    count(k == 0 ? "b0_medium" : "b1_medium", b.medium);
    count(k == 0 ? "b0_weak" : "b1_weak", b.weak);
  }
  for (const int k : {0, 1}) row.add(k == 0 ? "tp0" : "tp1", std::vector<double>{total_persistence(diagram, k)});
  return row;
}

bool holds_particles(const CsvFile& csv) {
  return find_column(csv, {"x"}) && (find_column(csv, {"radius", "r"}) || find_column(csv, {"diameter", "d"}));
}

struct MeasuredRuns {
  Table table;
  bool damaged = false;
};

/// Frame by frame; files that cannot be used are named and left out, unless all are.
MeasuredRuns measure_runs(const std::vector<std::string>& files, const MeasureOptions& options,
                          const std::vector<std::string>& names) {
  MeasuredRuns all;
  for (const std::string& file : files) try {
      Table part;
      const RunFile run(file);
      for (std::size_t f = 0; f < run.frames(); ++f) append(part, measure_packing(run.frame(f), options, names));
      append(all.table, part);
    } catch (const Error& error) {
      if (error.code() != ExitCode::data || files.size() == 1) throw;
      complain("error: {}\n", error.what());
      all.damaged = true;
    }
  return all;
}

Table measure_files(const std::vector<std::string>& files, const MeasureOptions& options,
                    const std::vector<std::string>& names) {
  if (files.size() == 2) {
    const bool first = holds_particles(CsvFile::read(files[0]));
    const ImportedPacking imported = read_packing_csv(files[first ? 0 : 1], files[first ? 1 : 0]);
    for (const std::string& note : imported.notes) complain("note: {}\n", note);
    return measure_packing(imported.packing, options, names);
  }
  if (files.size() != 1)
    throw usage_error("give a folder of results, run.h5 files, a network, or particles and contacts", "measure");
  if (!names.empty())
    throw usage_error("a network without grains has no measures of a packing to choose from", "--measure",
                      "give its particles too, or use `jamscape persistence`");
  return measure_network(files.front(), options);
}

ExitCode measure(const MeasureArguments& a) {
  std::error_code ignored;
  if (fs::is_directory(a.files.front(), ignored)) return measure_results(a);
  Study study;
  study.info.name = "measure";
  study.systems = {};
  study.base.stages.resize(1);
  const Study set = with_settings(study, a);
  const MeasuredRuns measured = fs::path(a.files.front()).extension() == ".h5"
                                    ? measure_runs(a.files, set.measure, a.names)
                                    : MeasuredRuns{measure_files(a.files, set.measure, a.names)};
  if (a.out.empty())
    fmt::print("{}", to_csv(measured.table));
  else
    write_csv(a.out, measured.table);
  return measured.damaged ? ExitCode::data : ExitCode::done;
}

}  // namespace

void add_measure(CLI::App& program, Action& action) {
  CLI::App* sub = program.add_subcommand("measure", "Measure stored frames, or packings and networks made elsewhere");
  auto a = std::make_shared<MeasureArguments>();
  sub->add_option("what", a->files, "a folder of results; run.h5 files; particles.csv and contacts.csv; or network.csv")
      ->required();
  sub->add_option("--measure,-m", a->names, "only these measures")->allow_extra_args(false);
  sub->add_option("--set", a->settings, "change an option of the measures: measure.KEY=value")->allow_extra_args(false);
  sub->add_option("--out,-o", a->out, "of files: CSV to write (default: standard output)");
  sub->add_flag("--again", a->again, "of a folder: also what has been measured before");
  sub->callback([a, &action] { action = [a] { return measure(*a); }; });
}

}  // namespace jam::app
