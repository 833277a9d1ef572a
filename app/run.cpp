#include "jamscape/study/run.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "commands.hpp"
#include "complain.hpp"
#include "find_study.hpp"
#include "jamscape/base/cores.hpp"
#include "jamscape/base/file_lacks.hpp"
#include "jamscape/base/progress.hpp"
#include "jamscape/base/stop_signal.hpp"
#include "jamscape/protocol/driver.hpp"
#include "jamscape/study/advice.hpp"
#include "jamscape/study/measure_task.hpp"
#include "jamscape/study/results.hpp"
#include "monitor.hpp"
#include "write_results.hpp"

namespace jam::app {
namespace {

namespace fs = std::filesystem;

struct RunArguments {
  std::string study, out, shard = "1/1";
  std::vector<std::string> settings, only;
  int jobs = 0, threads = 0;
  double checkpoint = 60;
  bool dry_run = false, json = false, quiet = false, strict = false;
};

/// What a simple estimate takes for granted until the run itself measures: grain-steps a second of one core.
double assumed_rate(const SystemOptions& system) {
  if (engine_of(system) == EngineKind::clusters) return system.domain.dimension == 2 ? 1e7 : 9e6;
  return 1e8;
}

/// Systems whose runs cannot use all the threads asked for.
std::vector<std::string> idle_threads(const Study& study, int wanted) {
  std::vector<std::string> said;
  for (const System& s : study.systems)
    if (const int used = threads_of_use(s.options, wanted); used < wanted)
      said.push_back(fmt::format("system '{}': of {} threads each run uses {}", s.name, wanted, used));
  return said;
}

ExitCode dry_run(const Study& study, const std::vector<Task>& tasks, const RunArguments& a, int jobs) {
  const std::vector<std::size_t> order = order_tasks(tasks, read_shard(a.shard));
  double cost = 0, core_seconds = 0;
  nlohmann::json list = nlohmann::json::array();
  for (const std::size_t k : order) {
    const Task& t = tasks[k];
    const std::string& system = study.systems[t.system].name;
    cost += t.cost(), core_seconds += t.cost() / assumed_rate(study.systems[t.system].options);
    if (a.json)
      list.push_back({{"task", t.hash},
                      {"system", system},
                      {"realisation", t.realisation},
                      {"steps", t.plan.steps},
                      {"grains", t.plan.bodies},
                      {"frames", t.plan.frames.size()}});
    else
      fmt::print("{}  {:24}  realisation {:3}  {:6} grains  {:10} steps  {:4} frames\n", t.hash, system, t.realisation,
                 t.plan.bodies, t.plan.steps, t.plan.frames.size());
  }
  std::vector<std::string> said = advice(study, tasks);
  for (std::string& text : idle_threads(study, a.threads)) said.push_back(std::move(text));
  const double seconds = core_seconds / std::max(1, std::min(jobs, static_cast<int>(order.size())));
  if (a.json)
    fmt::print(
        "{}\n",
        nlohmann::json{{"tasks", list}, {"grain_steps", cost}, {"seconds_estimated", seconds}, {"notes", said}}.dump());
  if (a.json) return ExitCode::done;
  for (const std::string& text : said) fmt::print("note: {}\n", text);
  fmt::print("{} runs, {:.2g} grain-steps, roughly {} on {} cores; nothing was run\n", order.size(), cost,
             print_duration(seconds), jobs);
  return ExitCode::done;
}

/// Cores that no other simulation needs, for each of those that run at a time.
int spare_threads(const std::vector<Task>& tasks, const fs::path& out, const RunOptions& options) {
  int left = 0;
  for (const std::size_t k : order_tasks(tasks, options.shard))
    left += !has_all_frames(TaskFolder(out, tasks[k].hash), tasks[k].plan);
  return std::max(1, usable_cores() / std::clamp(left, 1, options.jobs));
}

/// Of the runs that were none of this command's business but enter its tables.
std::vector<LeftOut> damage_of_others(const std::vector<Task>& all, const std::vector<Task>& tasks, const fs::path& out,
                                      const RunOptions& options) {
  std::set<std::string> mine;
  for (const std::size_t k : order_tasks(tasks, options.shard)) mine.insert(tasks[k].hash);
  std::vector<Task> others;
  std::copy_if(all.begin(), all.end(), std::back_inserter(others),
               [&](const Task& t) { return !mine.contains(t.hash); });
  return find_damage(others, out, options.jobs);
}

ExitCode run(const RunArguments& a) {
  // A folder of results holds its own study: naming it goes on with it.
  std::error_code ignored;
  const bool resume = fs::is_directory(a.study, ignored);
  const Study study = find_study(resume ? (fs::path(a.study) / "study.toml").string() : a.study, a.settings);
  const fs::path out = !a.out.empty() ? fs::path(a.out)
                       : resume       ? fs::path(a.study)
                                      : fs::path("results") / study.info.name;
  RunOptions options;
  options.jobs = a.jobs > 0 ? a.jobs : usable_cores();
  options.shard = read_shard(a.shard);
  options.checkpoint_interval = a.checkpoint;
  options.stop = stop_requested;
  chosen_measures(study);
  const std::vector<Task> all = plan_tasks(study);
  const std::vector<Task> tasks = a.only.empty() ? all : tasks_of(study, all, a.only);
  if (a.dry_run) return dry_run(study, tasks, a, options.jobs);

  watch_stop_signals();
  check_results(out, study);
  make_folder(out);
  options.threads = a.threads > 0 ? a.threads : spare_threads(tasks, out, options);
  if (!a.quiet)
    for (const std::string& text : idle_threads(study, a.threads)) complain("note: {}\n", text);
  const RunnerLock lock(out, options.shard);
  write_results_study(out, study);
  for (const std::string& lack : take_lacks()) complain("note: {}\n", lack);

  RunResult result;
  {
    const Show show = a.quiet ? Show::nothing : a.json ? Show::json : progress_terminal() ? Show::bar : Show::lines;
    Monitor monitor(study, tasks, order_tasks(tasks, options.shard), show, a.json ? stdout : stderr);
    result = run_tasks(study, tasks, out, options, monitor);
  }
  if (result.interrupted) {
    complain("interrupted; the same command goes on where it stopped\n");
    return ExitCode::interrupted;
  }
  if (result.failed > 0)
    complain("{} of {} runs failed; `jamscape status {}` says why\n", result.failed, result.failed + result.done,
             out.string());
  if (!result.complete) {
    complain("this share is done; tables and report are written when the last share ends\n");
    return result.failed > 0 ? ExitCode::some_failed : ExitCode::done;
  }
  const Warned warned = write_results(study, all, {ResultPlaces(out), out, damage_of_others(all, tasks, out, options)},
                                      a.json    ? Summary::json
                                      : a.quiet ? Summary::none
                                                : Summary::text);
  if (result.failed > 0) return ExitCode::some_failed;
  if (warned.damaged) return ExitCode::data;
  const std::size_t marked = study.info.ledger == LedgerRule::closed ? warned.marked : 0;
  return a.strict && warned.not_relaxed + marked > 0 ? ExitCode::not_converged : ExitCode::done;
}

}  // namespace

void add_run(CLI::App& program, Action& action) {
  CLI::App* sub = program.add_subcommand("run", "Simulate and measure a study; run again, it goes on where it stopped");
  auto a = std::make_shared<RunArguments>();
  sub->add_option("study", a->study, "study file, name of a built-in study, or a folder of results to go on with")
      ->required();
  sub->add_option("--out,-o", a->out, "folder of results (default: results/NAME)");
  sub->add_option("--jobs,-j", a->jobs, "simulations at a time (default: one a core)")->check(CLI::Range(1, 4096));
  sub->add_option("--threads,-t", a->threads,
                  "threads that share one simulation of 20000 discs or spheres or more; smaller ones and clusters have "
                  "one each. No result depends on it (default: cores that simulations at a time leave free)")
      ->check(CLI::Range(1, 4096));
  sub->add_option("--only", a->only, "do only the systems of these names: NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  sub->add_option("--shard", a->shard, "do only the i-th of n shares of the study: i/n");
  sub->add_option("--set", a->settings, "change an option: key=value, may be repeated")->allow_extra_args(false);
  sub->add_option("--checkpoint", a->checkpoint, "seconds between checkpoints of a simulation")
      ->check(CLI::Range(0.0, 1e6));
  sub->add_flag("--dry-run", a->dry_run, "list the simulations and what they cost; run nothing");
  sub->add_flag(
      "--json", a->json,
      "progress and summary as lines of JSON on standard output (without it: a bar on a terminal, else plain lines)");
  sub->add_flag("--quiet,-q", a->quiet, "say nothing but errors");
  sub->add_flag("--strict", a->strict, "end with exit code 4 when a relaxation did not converge or a frame is marked");
  sub->callback([a, &action] { action = [a] { return run(*a); }; });
}

}  // namespace jam::app
