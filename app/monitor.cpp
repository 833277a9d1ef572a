#include "monitor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "jamscape/base/progress.hpp"

namespace jam::app {
namespace {

constexpr double rate_window = 30;    // seconds over which the rate is averaged
constexpr double line_interval = 10;  // seconds between lines of progress at least
constexpr double quiet_time = 300;    // seconds after which a plain line comes even where a percent is not full

}  // namespace

Monitor::Monitor(const Study& study, const std::vector<Task>& tasks, const std::vector<std::size_t>& mine, Show show,
                 std::FILE* out)
    : study_(study), tasks_(tasks), mine_(mine), show_(show), out_(out), states_(tasks.size()) {
  for (std::size_t k = 0; k < tasks.size(); ++k) states_[k].steps = tasks[k].plan.steps;
}

Monitor::~Monitor() {
  if (bar_drawn_) put("\r\033[K");
}

std::string Monitor::name(std::size_t task) const {
  return fmt::format("{} {}", study_.systems[tasks_[task].system].name, tasks_[task].realisation + 1);
}

void Monitor::put(const std::string& text) {
  if (out_ && (std::fputs(text.c_str(), out_) < 0 || std::fflush(out_) != 0)) out_ = nullptr;
}

void Monitor::line(const std::string& text) {
  put(std::exchange(bar_drawn_, false) ? "\r\033[K" + text + "\n" : text + "\n");
}

void Monitor::event(std::size_t task, const char* what, const std::string& reason) {
  if (show_ == Show::nothing) {  // but errors, and what was mended
    if (!reason.empty()) line(fmt::format("{}: {} {}", what, name(task), reason));
  } else if (show_ == Show::json) {
    nlohmann::json json{{"event", what},
                        {"task", tasks_[task].hash},
                        {"system", study_.systems[tasks_[task].system].name},
                        {"realisation", tasks_[task].realisation}};
    if (!reason.empty()) json["reason"] = reason;
    line(json.dump());
  } else if (!reason.empty()) {
    line(fmt::format("{} {}: {}", name(task), what, reason));
  }
}

void Monitor::started(std::size_t task, bool resumed) {
  const std::lock_guard lock(mutex_);
  states_[task].phase = Phase::simulating;
  states_[task].resumed = resumed;
  event(task, resumed ? "resumed" : "started");
}

void Monitor::progress(std::size_t task, const Progress& progress) {
  const std::lock_guard lock(mutex_);
  State& s = states_[task];
  s.step = progress.step, s.steps = progress.steps;
  s.packing_fraction = progress.packing_fraction;
  if (!s.seen && s.resumed) s.found = s.step;
  s.seen = true;
}

void Monitor::measuring(std::size_t task) {
  const std::lock_guard lock(mutex_);
  State& s = states_[task];
  const bool simulated = s.phase == Phase::simulating && !s.resumed;
  if (s.seen) s.steps = s.step;
  if (!s.seen && !simulated) s.found = s.steps;
  s.step = s.steps;
  s.phase = Phase::measuring;
}

void Monitor::warned(std::size_t task, const std::string& reason) {
  const std::lock_guard lock(mutex_);
  event(task, "warning", reason);
}

void Monitor::finished(std::size_t task, bool simulated) {
  const std::lock_guard lock(mutex_);
  states_[task].phase = Phase::ended;
  event(task, simulated ? "finished" : "done before");
}

void Monitor::failed(std::size_t task, const std::string& reason) {
  const std::lock_guard lock(mutex_);
  State& s = states_[task];
  s.found += s.steps - s.step;  // what it did not do is behind us too, but was not gained
  s.step = s.steps;
  s.phase = Phase::ended;
  ++failures_;
  event(task, "failed", reason);
}

void Monitor::skipped(std::size_t task) {
  const std::lock_guard lock(mutex_);
  State& s = states_[task];
  s.step = s.found = s.steps;
  s.phase = Phase::ended;
  if (show_ != Show::nothing) event(task, "skipped", "another process works on it");
}

Monitor::Totals Monitor::totals() {
  Totals t;
  t.tasks = mine_.size();
  t.lowest = 1e9;
  for (const std::size_t k : mine_) {
    const State& s = states_[k];
    const auto bodies = static_cast<double>(tasks_[k].plan.bodies);
    t.cost += bodies * static_cast<double>(s.steps);
    t.behind += bodies * static_cast<double>(s.step);
    t.gained += bodies * static_cast<double>(s.step - s.found);
    t.ended += s.phase == Phase::ended;
    t.running += s.phase == Phase::simulating || s.phase == Phase::measuring;
    if (s.phase != Phase::simulating || !s.seen) continue;
    t.lowest = std::min(t.lowest, s.packing_fraction);
    t.highest = std::max(t.highest, s.packing_fraction);
  }
  const double now = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  samples_.emplace_back(now, t.gained);
  while (samples_.size() > 2 && now - samples_.front().first > rate_window) samples_.pop_front();
  const double seconds = now - samples_.front().first;
  if (seconds > 0) t.rate = (t.gained - samples_.front().second) / seconds;
  if (t.rate > 0) t.seconds_left = (t.cost - t.behind) / t.rate;
  return t;
}

std::vector<std::string> Monitor::notes(const Totals& t) const {
  std::vector<std::string> notes = {fmt::format("{}/{} runs", t.ended, t.tasks)};
  if (failures_ > 0) notes.push_back(fmt::format("{} failed", failures_));
  if (t.seconds_left >= 0 && t.ended < t.tasks) notes.push_back(print_duration(t.seconds_left) + " left");
  if (t.highest > 0) {
    notes.push_back(t.highest - t.lowest < 5e-4 ? fmt::format("phi {:.3f}", t.highest)
                                                : fmt::format("phi {:.3f}-{:.3f}", t.lowest, t.highest));
    notes.push_back(fmt::format("{:.1f} M grain-steps/s", t.rate / 1e6));
  }
  return notes;
}

void Monitor::draw_bar(const Totals& t) {
  put(fmt::format("\r{}\033[K", print_bar(t.fraction(), notes(t), terminal_width() - 1)));
  bar_drawn_ = true;
}

/// Of a run of days a line a percent is enough.
void Monitor::print_line(const Totals& t) {
  const double now = samples_.back().first, since = now - last_line_;
  const bool first = last_fraction_ < 0, ended = t.ended == t.tasks;
  if (!first && !ended && (since < line_interval || (t.fraction() - last_fraction_ < 0.01 && since < quiet_time)))
    return;
  if (ended && last_fraction_ >= 1) return;
  last_line_ = now, last_fraction_ = t.fraction();
  line(fmt::format("{:3.0f} %  {}", std::floor(100 * t.fraction()), fmt::join(notes(t), "  ")));
}

void Monitor::print_json(const Totals& t) {
  const double now = samples_.back().first;
  if (now - last_line_ < line_interval && t.ended < t.tasks) return;
  last_line_ = now;
  nlohmann::json json{{"event", "progress"},
                      {"done", t.ended},
                      {"tasks", t.tasks},
                      {"running", t.running},
                      {"failed", failures_},
                      {"grain_steps_per_second", t.rate},
                      {"fraction", t.fraction()}};
  if (t.seconds_left >= 0) json["seconds_left"] = t.seconds_left;
  for (const std::size_t k : mine_)
    if (const State& s = states_[k]; s.phase == Phase::simulating && s.seen)
      json["runs"].push_back(
          {{"task", tasks_[k].hash}, {"step", s.step}, {"steps", s.steps}, {"packing_fraction", s.packing_fraction}});
  line(json.dump());
}

void Monitor::tick() {
  if (show_ == Show::nothing) return;
  const std::lock_guard lock(mutex_);
  const Totals t = totals();
  if (show_ == Show::bar)
    draw_bar(t);
  else if (show_ == Show::lines)
    print_line(t);
  else
    print_json(t);
}

}  // namespace jam::app
