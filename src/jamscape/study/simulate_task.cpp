#include "jamscape/study/simulate_task.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "jamscape/base/error.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/base/hash.hpp"
#include "jamscape/io/archive_file.hpp"
#include "jamscape/study/damage.hpp"
#include "jamscape/study/version.hpp"

namespace jam {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* frames_done_entry = "study/frames_done";
constexpr const char* plan_entry = "study/plan";

/// Processor time of this thread, which leads one simulation.
double cpu_now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Which frames were planned; a checkpoint is of use only to a run that plans the same.
std::string plan_key(const Plan& plan) {
  std::string text;
  for (const PlannedFrame& f : plan.frames) text += fmt::format("{} {} {}\n", f.stage, f.packing_fraction, f.step);
  return short_hash(text);
}

/// Without the suggestion, where it is followed already.
std::string first_line(const std::string& message) { return message.substr(0, message.find('\n')); }

struct Resume {
  Archive state;
  std::size_t frames_done = 0;
};

/// The checkpoint, if there is one that fits and all frames before it are still there.
std::optional<Resume> find_checkpoint(const Task& task, const TaskFolder& folder, const SimulateHooks& hooks) {
  std::error_code ignored;
  if (!fs::exists(folder.checkpoint(), ignored)) return std::nullopt;
  try {
    Resume resume{read_archive(folder.checkpoint()), 0};
    const auto done = resume.state.extract(frames_done_entry);
    const auto plan = resume.state.extract(plan_entry);
    if (done.empty() || plan.empty() || std::get<std::string>(plan.mapped()) != plan_key(task.plan))
      return std::nullopt;
    resume.frames_done = static_cast<std::size_t>(std::get<std::vector<std::int64_t>>(done.mapped()).at(0));
    for (std::size_t k = 0; k < resume.frames_done; ++k)
      if (!fs::exists(folder.frame(k), ignored)) return std::nullopt;
    return resume;
  } catch (const std::exception& error) {
    folder.log(nlohmann::json{{"event", "checkpoint unusable"}, {"reason", error.what()}}.dump());
    if (hooks.warning) hooks.warning(fmt::format("{}\n  the run begins again", first_line(error.what())));
    return std::nullopt;
  }
}

Outcome simulate_from(const Study& study, const Task& task, const TaskFolder& folder, const SimulateHooks& hooks,
                      const Resume* resume) {
  std::size_t frames_done = resume ? resume->frames_done : 0;
  auto saved = Clock::now();
  Hooks engine;
  engine.threads = hooks.threads;
  engine.progress = hooks.progress;
  engine.stop = hooks.stop;
  engine.largest_ledger_error =
      study.info.ledger == LedgerRule::open ? std::numeric_limits<double>::infinity() : study.info.ledger_stop;
  engine.checkpoint_due = [&] {
    return std::chrono::duration<double>(Clock::now() - saved).count() >= hooks.checkpoint_interval;
  };
  engine.checkpoint = [&](const Archive& state) {
    Archive all = state;
    all[frames_done_entry] = std::vector<std::int64_t>{static_cast<std::int64_t>(frames_done)};
    all[plan_entry] = plan_key(task.plan);
    write_archive(folder.checkpoint(), all);
    saved = Clock::now();
  };
  engine.frame = [&](std::size_t index, const Packing& packing) {
    write_frame(folder.frame(index), packing);
    frames_done = index + 1;
  };
  return simulate(study.systems[task.system].options, task.key, engine, resume ? &resume->state : nullptr);
}

void assemble(const Study& study, const Task& task, const TaskFolder& folder) {
  std::vector<fs::path> files;
  for (std::size_t k = 0; k < task.plan.frames.size(); ++k) files.push_back(folder.frame(k));
  const Provenance provenance{
      task_text(study, task),
      std::string(program_version()),
      {{"commit", std::string(program_commit())},
       {"hash", task.hash},
       {"physics_revision", fmt::format("{}", physics_revision(study.systems[task.system].options))},
       {"realisation", fmt::format("{}", task.realisation)},
       {"seed", fmt::format("{}", task.key.seed)}}};
  assemble_run(files, folder.run_file(), provenance);
}

/// Where relaxations are, the plan only guesses how long they take.
std::int64_t last_step(const Task& task, const TaskFolder& folder) {
  if (task.plan.frames.empty() || task.plan.frames.back().step >= 0) return task.plan.steps;
  return RunFile(folder.run_file(), Look::structure).steps().back();
}

/// Why one of the frames taken cannot be read, or "".
std::string damaged_frame(const Task& task, const TaskFolder& folder) {
  for (std::size_t k = 0; k < task.plan.frames.size(); ++k) try {
      read_frame(folder.frame(k));
    } catch (const Error& error) {
      return error.what();
    }
  return {};
}

/// From the checkpoint, if there is one of use, to the end or until stopped.
Outcome simulate_rest(const Study& study, const Task& task, const TaskFolder& folder, const SimulateHooks& hooks) {
  make_folder(folder.frames());
  const std::optional<Resume> resume = find_checkpoint(task, folder, hooks);
  if (!resume) {
    folder.discard_partial();
    make_folder(folder.frames());
  }
  folder.log(nlohmann::json{{"event", resume ? "resumed" : "started"}, {"commit", program_commit()}}.dump());
  return simulate_from(study, task, folder, hooks, resume ? &*resume : nullptr);
}

}  // namespace

std::string task_text(const Study& study, const Task& task) {
  Study one;
  one.info = study.info;
  one.info.name = task.hash, one.info.title.clear(), one.info.realisations = 1, one.info.targets.clear();
  one.base = study.systems[task.system].options;
  one.units = study.systems[task.system].units;
  one.systems = {{task.hash, one.base, one.units, study.systems[task.system].scales, {}}};
  return print_study(one) +
         fmt::format(
             "\n[program]\nversion = {}\ncommit = {}\nphysics_revision = {}\nphysics_key = {}\nrealisation = {}\n",
             print_text(program_version()), print_text(program_commit()), physics_revision(one.base),
             print_text(task.key.system), task.realisation);
}

Outcome simulate_task(const Study& study, const Task& task, const TaskFolder& folder, const SimulateHooks& hooks) {
  const auto warn = [&](const char* event, const std::string& reason, const std::string& what_now) {
    folder.log(nlohmann::json{{"event", event}, {"reason", reason}}.dump());
    if (hooks.warning) hooks.warning(reason + "\n  " + what_now);
  };
  if (const auto stored = check_stored(folder)) {
    if (stored->verdict == RunCheck::Verdict::unreadable)
      throw data_error(stored->reason, {}, "move run.h5 away to simulate again");
    std::string damage = stored->verdict == RunCheck::Verdict::damaged ? stored->reason : "";
    if (stored->verdict == RunCheck::Verdict::not_covered) damage = damaged_content(folder);
    if (!damage.empty()) {
      const fs::path aside = folder.set_aside_run();
      warn("run set aside", first_line(damage), fmt::format("it is now {}, and is simulated again", aside.string()));
    } else if (has_all_frames(folder, task.plan)) {
      folder.discard_partial();
      return Outcome::finished;
    }
  }
  make_folder(folder.path());
  write_text(folder.path() / "task.toml", task_text(study, task));
  const auto begin = Clock::now();
  const double cpu_begin = cpu_now();
  Outcome outcome = simulate_rest(study, task, folder, hooks);
  if (outcome == Outcome::finished) try {
      assemble(study, task, folder);
    } catch (const Error&) {
      const std::string reason = damaged_frame(task, folder);
      if (reason.empty()) throw;  // the disk, not the frames
      const fs::path aside = folder.set_aside_frames();
      warn("frames set aside", reason,
           fmt::format("the frames of this run are now in {} and are simulated again", aside.string()));
      outcome = simulate_rest(study, task, folder, hooks);
      if (outcome == Outcome::finished) assemble(study, task, folder);
    }
  if (outcome == Outcome::finished) folder.discard_partial();
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  folder.log(nlohmann::json{{"event", outcome == Outcome::finished ? "finished" : "stopped"},
                            {"seconds", seconds},
                            {"cpu_seconds", cpu_now() - cpu_begin},
                            {"steps", outcome == Outcome::finished ? last_step(task, folder) : task.plan.steps},
                            {"bodies", task.plan.bodies}}
                 .dump());
  return outcome;
}

}  // namespace jam
