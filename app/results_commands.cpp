// Commands on a folder of results: report, score, verify, view, export.
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands.hpp"
#include "jamscape/base/cores.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/base/progress.hpp"
#include "jamscape/base/stop_signal.hpp"
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
  write_study(to, study_of_results(from));
  for (const auto& entry : fs::directory_iterator(from))
    if (entry.path().filename().string().ends_with(".csv.gz"))
      fs::copy_file(entry.path(), fs::path(to) / entry.path().filename(), fs::copy_options::overwrite_existing);
}

ExitCode damage_code(bool damaged) { return damaged ? ExitCode::data : ExitCode::done; }

/// Of simulations that stand in DIR, tables, means and report in DIR or elsewhere.
ExitCode report_simulated(const fs::path& dir, const fs::path& to) {
  const Study study = study_of_results(dir);
  const std::vector<Task> tasks = stored_tasks(study, dir);
  if (to == dir) {
    if (!may_write_results(dir, tasks))
      throw data_error("nothing can be written here", dir.string(), "--out FOLDER: report, tables and means go there");
  } else {
    check_results(to, study);
    write_study(to, study);
  }
  const ResultPlaces places(dir, to);
  const std::vector<LeftOut> left_out = measure_tasks(study, tasks, places, usable_cores(), Remeasure::missing);
  return damage_code(write_results(study, tasks, {places, to, left_out}, Summary::text).damaged);
}

ExitCode report(const std::string& from, const std::string& out) {
  std::error_code ignored;
  if (!is_collected(from))
    return report_simulated(from, out.empty() || fs::equivalent(from, out, ignored) ? from : out);
  if (!out.empty()) copy_collected(from, out);
  const std::string& dir = out.empty() ? from : out;
  if (!fs::exists(fs::path(dir) / "study.toml", ignored))
    throw usage_error("these tables have no study.toml, so a report cannot stand beside them", dir, "--out FOLDER");
  if (!may_write(dir)) throw data_error("nothing can be written here", dir, "--out FOLDER");
  const Study study = study_of_results(dir);
  write_results(study, stored_tasks(study, dir), {ResultPlaces(dir), dir, {}}, Summary::text);
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

ExitCode score(const std::string& dir, const std::string& file, bool as_json, bool unmarked) {
  Study study = study_of_results(dir);
  if (unmarked) study.info.ledger = LedgerRule::closed;
  const std::vector<Target> targets = find_targets(study, file);
  const std::vector<Task> tasks = stored_tasks(study, dir);
  std::optional<ScratchFolder> scratch;
  if (!may_write_results(dir, tasks)) scratch.emplace("score");
  const ResultPlaces places(dir, scratch ? scratch->path() : fs::path(dir));
  const std::vector<LeftOut> left_out = measure_tasks(study, tasks, places, usable_cores(), Remeasure::missing);
  const bool damaged = name_left_out(left_out, study, tasks);
  const std::vector<Score> scores = score_targets(targets, study, find_done(study, tasks, places, left_out));
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
  if (as_json) return damage_code(damaged);
  const auto elsewhere =
      std::count_if(targets.begin(), targets.end(), [&](const Target& t) { return !concerns(t, study); });
  fmt::print("\n{} pass, {} fail, {} known deviations, {} with too few runs\n", count[0], count[1], count[2], count[3]);
  if (elsewhere > 0) fmt::print("{} targets are of systems that this study does not have\n", elsewhere);
  return damage_code(damaged);
}

/// What a run's bytes and a second simulation say about it.
struct Verified {
  bool same = false, stopped = false;
  std::string text;
};

Verified verify_one(const Study& study, const Task& task, const std::string& dir) {
  const auto stored = check_stored(TaskFolder(dir, task.hash));
  if (!stored->usable()) return {false, false, stored->reason};
  try {
    const auto difference = verify_task(study, task, dir, {}, stop_requested);
    if (!difference) return {false, true, "stopped"};
    if (!difference->empty()) return {false, false, *difference};
  } catch (const std::exception& error) {
    return {false, false, error.what()};
  }
  return {true, false,
          fmt::format("{} frames, the same bits{}", task.plan.frames.size(),
                      stored->verdict == RunCheck::Verdict::not_covered
                          ? "; not covered by a seal: written before run files had one"
                          : "")};
}

ExitCode verify(const std::string& dir, const std::string& hash, bool all, int jobs) {
  const Study study = study_of_results(dir);
  const std::vector<Task> tasks = stored_tasks(study, dir);
  const int cores = jobs > 0 ? jobs : usable_cores();
  const std::vector<LeftOut> damaged = find_damage(tasks, dir, cores);
  std::vector<std::size_t> chosen;
  for (const std::size_t k : order_tasks(tasks, {})) {
    if (!tasks[k].hash.starts_with(hash)) continue;
    const bool bad = is_left_out(damaged, tasks[k].hash);
    if (bad || has_all_frames(TaskFolder(dir, tasks[k].hash), tasks[k].plan)) chosen.push_back(k);
  }
  if (chosen.empty())
    throw data_error(hash.empty() ? "no run is done yet" : fmt::format("no run named '{}' is done", hash), dir,
                     fmt::format("jamscape status {}", dir));
  if (!all) {  // the shortest that is whole, and all that are not
    const auto whole = [&](std::size_t k) { return !is_left_out(damaged, tasks[k].hash); };
    const auto shortest = std::find_if(chosen.rbegin(), chosen.rend(), whole);
    const std::size_t kept = shortest != chosen.rend() ? *shortest : tasks.size();
    std::erase_if(chosen, [&](std::size_t k) { return whole(k) && k != kept; });
  }
  watch_stop_signals();
  std::vector<Verified> verified(chosen.size());
  run_jobs(chosen.size(), cores, [&](std::size_t k) { verified[k] = verify_one(study, tasks[chosen[k]], dir); });
  bool same = true, stopped = false;
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    const Task& t = tasks[chosen[k]];
    same = same && verified[k].same;
    stopped = stopped || verified[k].stopped;
    fmt::print("{}  {}  realisation {}: {}\n", t.hash, study.systems[t.system].name, t.realisation, verified[k].text);
  }
  return stopped ? ExitCode::interrupted : same ? ExitCode::done : ExitCode::data;
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

/// The frames of a task as tables; how many.
std::size_t export_task(const Task& task, const TaskFolder& folder, const fs::path& place) {
  const RunFile run(folder.run_file(), Look::structure);
  const std::vector<std::size_t> stored = stored_frames(run, task.plan).value();
  make_folder(place);
  for (std::size_t f = 0; f < stored.size(); ++f)
    write_packing_csv(run.frame(stored[f]), place / fmt::format("particles-{:06}.csv", f),
                      place / fmt::format("contacts-{:06}.csv", f));
  return stored.size();
}

ExitCode export_csv(const std::string& dir, const fs::path& out) {
  const Study study = study_of_results(dir);
  const std::vector<Task> tasks = stored_tasks(study, dir);
  std::vector<LeftOut> left_out = find_damage(tasks, dir, usable_cores());
  std::size_t written = 0;
  for (const Task& t : tasks) {
    const TaskFolder folder(dir, t.hash);
    if (is_left_out(left_out, t.hash) || !has_all_frames(folder, t.plan)) continue;
    try {
      written += export_task(t, folder, out / fmt::format("{}-{}", study.systems[t.system].name, t.realisation));
    } catch (const Error&) {  // a run without a seal shows its damage only when it is read
      const std::string damage = damaged_content(folder);
      if (damage.empty()) throw;
      left_out.push_back({t.hash, damage});
    }
  }
  const bool damaged = name_left_out(left_out, study, tasks);
  fmt::print("{} frames written below {}\n", written, out.string());
  return damage_code(damaged);
}

}  // namespace

void add_results_commands(CLI::App& program, Action& action) {
  struct Arguments {
    std::string dir, file, hash, out;
    bool json = false, all = false, unmarked = false;
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
  r->add_option("--out,-o", a->out, "another folder for them, where nothing can or shall be written into DIR");
  CLI::App* s = add("score", "Published values beside ours, one row per target",
                    [](const Arguments& x) { return score(x.dir, x.file, x.json, x.unmarked); });
  s->add_option("--targets", a->file, "file of targets (default: those the study names)");
  s->add_flag("--json", a->json, "one line of JSON per target");
  s->add_flag("--unmarked", a->unmarked, "leave marked frames out, also where the study takes them into its means");
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
