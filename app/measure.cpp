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
#include "jamscape/base/printable.hpp"
#include "jamscape/io/csv.hpp"
#include "jamscape/study/measure_task.hpp"
#include "jamscape/study/results.hpp"
#include "measure_files.hpp"
#include "write_results.hpp"

namespace jam::app {
namespace {

namespace fs = std::filesystem;

struct MeasureArguments {
  std::vector<std::string> files, settings, names;
  std::string out;
  std::optional<double> frame;
  bool again = false, walls = false, anyway = false;
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
  for (const std::string& text : a.settings)
    if (read_setting(text).key == "measure.gravity")
      throw usage_error("measure.gravity is for packings of files: the systems of a study have their own", "--set",
                        "domain.gravity, in a new run");
  Study study = with_settings(study_of_results(dir), a);
  if (!a.names.empty() && !study.measures.list.empty())
    for (const std::string& name : a.names)
      if (std::find(study.measures.list.begin(), study.measures.list.end(), name) == study.measures.list.end())
        study.measures.list.push_back(name);
  chosen_measures(study);
  const std::vector<Task> tasks = stored_tasks(study, dir);
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

void refuse_for_folder(const MeasureArguments& a) {
  const auto refuse = [](const char* option, const char* advice) {
    throw usage_error(fmt::format("{} is for files, not for a folder of results", option), "measure", advice);
  };
  if (a.files.size() > 1)
    throw usage_error(fmt::format("a folder of results is measured alone, not beside '{}'", a.files[1]), "measure",
                      "give one folder at a time");
  if (!a.out.empty())
    refuse("--out", "its tables are written into the folder; `jamscape export` writes packings elsewhere");
  if (a.frame) refuse("--frame", "its tables name the frame of every row");
  if (a.walls) refuse("--walls", "a packing's walls are known, and are no vertices");
  if (a.anyway) refuse("--anyway", "");
}

ExitCode measure(const MeasureArguments& a) {
  std::error_code ignored;
  for (const std::string& file : a.files)
    if (fs::is_directory(file, ignored) && &file != &a.files.front())
      throw usage_error(fmt::format("'{}' is a folder, '{}' is not measured beside it", file, a.files.front()),
                        "measure", "give one folder, or files");
  if (fs::is_directory(a.files.front(), ignored)) {
    refuse_for_folder(a);
    return measure_results(a);
  }
  if (a.again)
    throw usage_error("--again is for a folder of results", "measure",
                      "files are measured anew every time: leave it out");
  Study study;
  study.info.name = "measure";
  study.systems = {};
  study.base.stages.resize(1);
  Study set = with_settings(study, a);
  FileRequest request{a.files, a.names, {}, set.measure, a.frame, a.walls, a.anyway};
  if (request.measures.empty()) request.measures = set.measures.list;
  for (const std::string& text : a.settings) request.set.push_back(read_setting(text).key);
  if (std::find(request.set.begin(), request.set.end(), "measure.rows_every") == request.set.end())
    request.options.rows_every = 0;  // who gives files wants them measured
  const FileResult measured = measure_files(request);
  for (const std::string& note : measured.notes) complain("note: {}\n", printable(note));
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
  sub->add_option("--frame", a->frame, "of files with several frames: the one to measure (run.h5: counted from 0)");
  sub->add_flag("--walls", a->walls, "of a network: walls (negative numbers) become vertices");
  sub->add_flag("--anyway", a->anyway, "of a network: however much memory it takes");
  sub->add_flag("--again", a->again, "of a folder: also what has been measured before");
  sub->callback([a, &action] { action = [a] { return measure(*a); }; });
}

}  // namespace jam::app
