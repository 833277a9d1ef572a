// Commands on a folder of results: report, score, verify, view, export.
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/base/progress.hpp"
#include "jamscape/base/threads.hpp"
#include "jamscape/io/packing_csv.hpp"
#include "jamscape/study/builtin.hpp"
#include "jamscape/study/collected.hpp"
#include "jamscape/study/results.hpp"
#include "jamscape/study/score.hpp"
#include "jamscape/study/verify.hpp"
#include "write_results.hpp"

namespace jam::app {
namespace {

namespace fs = std::filesystem;

/// Tables kept elsewhere become a folder of their own that holds them and what is made of them.
void copy_collected(const std::string& from, const std::string& to) {
  if (!is_collected(from))
    throw usage_error("--out is for tables kept without their simulations", from,
                      "leave it out: the report stays with the results");
  write_study(to, study_of_results(from));
  for (const auto& entry : fs::directory_iterator(from))
    if (entry.path().filename().string().ends_with(".csv.gz"))
      fs::copy_file(entry.path(), fs::path(to) / entry.path().filename(), fs::copy_options::overwrite_existing);
}

ExitCode report(const std::string& from, const std::string& out) {
  if (!out.empty()) copy_collected(from, out);
  const std::string& dir = out.empty() ? from : out;
  std::error_code ignored;
  if (is_collected(dir) && !fs::exists(fs::path(dir) / "study.toml", ignored))
    throw usage_error("these tables have no study.toml, so a report cannot stand beside them", dir, "--out FOLDER");
  const Study study = study_of_results(dir);
  const std::vector<Task> tasks = list_tasks(study);
  measure_tasks(study, tasks, dir, usable_cores(), Remeasure::missing);
  write_results(study, tasks, dir, Summary::text);
  return ExitCode::done;
}

std::vector<Target> find_targets(const Study& study, const std::string& file) {
  if (!file.empty()) return read_targets(read_text(file), file);
  if (study.info.targets.empty())
    throw usage_error(fmt::format("the study '{}' names no published values to compare with", study.info.name),
                      "study.targets", "--targets FILE");
  const std::string name = study.info.targets + ".targets.toml";
  const std::string_view text = builtin_file(name);
  if (text.empty())
    throw usage_error(fmt::format("there are no built-in targets '{}'", name), "study.targets", "--targets FILE");
  return read_targets(text, name);
}

std::string print_ours(const Score& s) {
  if (!std::isfinite(s.ours)) return "-";
  return std::isfinite(s.error) ? fmt::format("{:.4g} +- {:.2g}", s.ours, s.error) : fmt::format("{:.4g}", s.ours);
}

ExitCode score(const std::string& dir, const std::string& file, bool as_json) {
  const Study study = study_of_results(dir);
  const std::vector<Target> targets = find_targets(study, file);
  const std::vector<Task> tasks = list_tasks(study);
  measure_tasks(study, tasks, dir, usable_cores(), Remeasure::missing);
  const std::vector<Score> scores = score_targets(targets, study, find_done(study, tasks, dir));
  std::size_t count[4] = {};
  for (const Score& s : scores) {
    ++count[static_cast<std::size_t>(s.verdict)];
    if (as_json)
      fmt::print("{}\n", nlohmann::json{{"target", s.target},
                                        {"source", s.source},
                                        {"systems", s.systems},
                                        {"published", s.published},
                                        {"ours", s.ours},
                                        {"error", s.error},
                                        {"n", s.n},
                                        {"needed", s.needed},
                                        {"verdict", verdict_name(s.verdict)},
                                        {"note", s.note}}
                             .dump());
    else
      fmt::print("{:15} {}\n                {}  [{}]  published {}   ours {}   runs {} of {}{}{}\n",
                 verdict_name(s.verdict), s.target, s.systems, s.source, s.published, print_ours(s), s.n, s.needed,
                 s.note.empty() ? "" : "   ", s.note);
  }
  if (as_json) return ExitCode::done;
  const auto elsewhere =
      std::count_if(targets.begin(), targets.end(), [&](const Target& t) { return !concerns(t, study); });
  fmt::print("\n{} pass, {} fail, {} known deviations, {} with too few runs\n", count[0], count[1], count[2], count[3]);
  if (elsewhere > 0) fmt::print("{} targets are of systems that this study does not have\n", elsewhere);
  return ExitCode::done;
}

ExitCode verify(const std::string& dir, const std::string& hash, bool all, int jobs) {
  const Study study = study_of_results(dir);
  const std::vector<Task> tasks = list_tasks(study);
  std::vector<std::size_t> chosen;
  for (const std::size_t k : order_tasks(tasks, {}))
    if (has_all_frames(TaskFolder(dir, tasks[k].hash), tasks[k].plan) &&
        (hash.empty() || tasks[k].hash.starts_with(hash)))
      chosen.push_back(k);
  if (chosen.empty())
    throw data_error(hash.empty() ? "no run is done yet" : fmt::format("no run named '{}' is done", hash), dir,
                     fmt::format("jamscape status {}", dir));
  if (!all) chosen = {chosen.back()};  // the shortest
  std::vector<std::string> differences(chosen.size());
  run_jobs(chosen.size(), jobs > 0 ? jobs : usable_cores(),
           [&](std::size_t k) { differences[k] = verify_task(study, tasks[chosen[k]], dir); });
  bool same = true;
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    const Task& t = tasks[chosen[k]];
    same = same && differences[k].empty();
    fmt::print("{}  {}  realisation {}: {}\n", t.hash, study.systems[t.system].name, t.realisation,
               differences[k].empty() ? fmt::format("{} frames, the same bits", t.plan.frames.size()) : differences[k]);
  }
  return same ? ExitCode::done : ExitCode::data;
}

ExitCode view(const std::string& dir) {
  const fs::path page = fs::absolute(fs::path(dir) / "report.html").lexically_normal();
  std::error_code ignored;
  if (!fs::exists(page, ignored))
    throw usage_error("there is no report yet", dir, fmt::format("jamscape report {}", dir));
  const bool desktop = std::getenv("DISPLAY") || std::getenv("WAYLAND_DISPLAY");
  if (const pid_t child = desktop ? ::fork() : -1; child == 0) {
    ::execlp("xdg-open", "xdg-open", page.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  } else if (child > 0) {
    int status = 0;
    if (::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0) return ExitCode::done;
  }
  fmt::print("open in a browser: file://{}\n", page.string());
  return ExitCode::done;
}

ExitCode export_csv(const std::string& dir, const fs::path& out) {
  const Study study = study_of_results(dir);
  const std::vector<Task> tasks = list_tasks(study);
  std::size_t written = 0;
  for (const Task& t : tasks) {
    const TaskFolder folder(dir, t.hash);
    if (!has_all_frames(folder, t.plan)) continue;
    const RunFile run(folder.run_file());
    const std::vector<std::size_t> stored = stored_frames(run, t.plan).value();
    const fs::path place = out / fmt::format("{}-{}", study.systems[t.system].name, t.realisation);
    make_folder(place);
    for (std::size_t f = 0; f < stored.size(); ++f, ++written)
      write_packing_csv(run.frame(stored[f]), place / fmt::format("particles-{:06}.csv", f),
                        place / fmt::format("contacts-{:06}.csv", f));
  }
  fmt::print("{} frames written below {}\n", written, out.string());
  return ExitCode::done;
}

}  // namespace

void add_results_commands(CLI::App& program, Action& action) {
  struct Arguments {
    std::string dir, file, hash, out;
    bool json = false, all = false;
    int jobs = 0;
  };
  auto a = std::make_shared<Arguments>();
  const auto add = [&](const char* name, const char* text, auto run) {
    CLI::App* sub = program.add_subcommand(name, text);
    sub->add_option("dir", a->dir, "folder of results")->required();
    sub->callback([a, run, &action] { action = [a, run] { return run(*a); }; });
    return sub;
  };
  CLI::App* r = add("report", "Write tables, means and DIR/report.html again from what is stored",
                    [](const Arguments& x) { return report(x.dir, x.out); });
  r->add_option("--out,-o", a->out, "another folder for them, where DIR holds collected tables only");
  CLI::App* s = add("score", "Published values beside ours, one row per target",
                    [](const Arguments& x) { return score(x.dir, x.file, x.json); });
  s->add_option("--targets", a->file, "file of targets (default: those the study names)");
  s->add_flag("--json", a->json, "one line of JSON per target");
  CLI::App* v = add("verify", "Run a simulation again and compare every bit of its frames (exit code 3 if they differ)",
                    [](const Arguments& x) { return verify(x.dir, x.hash, x.all, x.jobs); });
  v->add_option("--task", a->hash, "hash of the run, or its beginning (default: the shortest)");
  v->add_flag("--all", a->all, "all runs that are done");
  v->add_option("--jobs,-j", a->jobs, "simulations at a time (default: one a core)")->check(CLI::Range(1, 4096));
  add("view", "Open the report", [](const Arguments& x) { return view(x.dir); });
  CLI::App* e = add("export", "Write every stored frame as two CSV tables, of particles and of contacts",
                    [](const Arguments& x) { return export_csv(x.dir, x.out); });
  e->add_option("--out,-o", a->out, "folder for the tables")->required();
}

}  // namespace jam::app
