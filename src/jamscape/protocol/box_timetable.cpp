#include "jamscape/protocol/box_timetable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

constexpr double balanced = 0.01;  // unbalanced part of a packing at rest

/// The decimal number that was meant where arithmetic left the last digits of one (.68 for .6799999999999999).
double decimal(double a) {
  const double meant = std::strtod(fmt::format("{:.12g}", a).c_str(), nullptr);
  return std::abs(meant - a) <= 8 * std::numeric_limits<double>::epsilon() * std::abs(a) ? meant : a;
}

/// Three digits, rounded down.
std::string below(double a) { return fmt::format("{}", decimal(std::floor(a * 1000) / 1000)); }

/// `rise` of the packing fraction in a step of a wall of `speed`: two frames, at `before` and `rho`, fall into one.
[[noreturn]] void refuse_one_step(const std::string& stage, double before, double rho, double rise, double way,
                                  double speed) {
  const auto most = static_cast<std::int64_t>(way / (2 * rise)) + 1;
  throw usage_error(
      "stage." + stage + ".frames: those at " + fmt::format("{:.6g}", before) + " and " + fmt::format("{:.6g}", rho) +
          " fall into one time step, in which the packing fraction rises by " + fmt::format("{:.2g}", rise),
      {},
      fmt::format("frames = {} or fewer, speed = {:.1g}, or a shorter integrator.step", std::max<std::int64_t>(most, 2),
                  speed * (rho - before) / (2 * rise)));
}

}  // namespace

std::string short_number(double a) {
  std::string s = std::to_string(a);
  s.erase(s.find_last_not_of('0') + 1);
  return s.back() == '.' ? s + "0" : s;
}

BoxTimetable::BoxTimetable(const StartBox& box, const SystemOptions& system)
    : dt_(system.integrator.step), box_(box.measure), length_(box.length), reached_(system.start.packing_fraction) {
  table_.plan.start = packing_fraction();
  table_.plan.axis = &planned_packing_fraction;
  for (const StageOptions& stage : system.stages)
    if (first_speed_ == 0 && stage.traits().moves) first_speed_ = stage.speed;
}

void BoxTimetable::refuse_below(double to, bool on_grid) const {
  const double fraction = packing_fraction();
  const bool box_above = fraction > to + 1e-9;
  if (!box_above && !(reached_ > to + 1e-9 && (!at_start() || on_grid))) return;
  throw usage_error(
      "stage." + stage_ + ".to = " + short_number(to) + " is below the packing fraction " +
          short_number(box_above ? fraction : reached_) + " the stage starts from",
      {},
      box_above ? "a larger `to`, or a smaller start.packing_fraction"
                : "a larger `to`, or start.packing_fraction = " + below(fraction) + ", which the start reaches");
}

void BoxTimetable::close_to(double to, double speed, const std::vector<double>& frames) {
  const double closing = 2 * speed * dt_;
  const std::int64_t steps = steps_for(length_ - box_.length(to), closing);
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const std::int64_t offset = std::min(steps, steps_for(length_ - box_.length(frames[f]), closing));
    if (f > 0 && table_.places.back().offset == offset) {
      const double rise = frames[f] - box_.packing_fraction(box_.length(frames[f]) + closing);
      refuse_one_step(stage_, frames[f - 1], frames[f], rise, to - std::min(frames[f - 1], reached_), speed);
    }
    add_frame(frames[f], offset, false);
  }
  table_.legs.push_back({stage_, LegKind::move, speed, steps});
  table_.plan.steps += steps;
  length_ -= closing * static_cast<double>(steps);
  reached_ = to;
}

void BoxTimetable::close_to_start() {
  if (!at_start() || !(reached_ > packing_fraction() + 1e-9)) return;
  if (first_speed_ > 0)
    close_to(reached_, first_speed_, {});
  else
    reached_ = packing_fraction();
}

void BoxTimetable::rest(const RelaxOptions& options) {
  add_frame(reached_, 0, true);
  const std::int64_t guess = guess_relaxation(options);
  Leg leg{stage_, LegKind::relax, 0, guess, options};
  if (leg.relax.unbalanced < 0) leg.relax.unbalanced = box_.walls == WallModel::periodic ? balanced : 0;
  table_.legs.push_back(leg);
  table_.plan.steps += guess;
  clock_known_ = false;
}

Timetable BoxTimetable::finish() {
  if (table_.plan.frames.empty() && !table_.legs.empty()) {
    table_.plan.frames.push_back({stage_, decimal(reached_), clock_known_ ? table_.plan.steps : -1, false});
    table_.places.push_back({table_.legs.size() - 1, table_.legs.back().steps});
  }
  return std::move(table_);
}

void BoxTimetable::add_frame(double rho, std::int64_t offset, bool relaxed) {
  const bool known = clock_known_ && !relaxed;
  table_.plan.frames.push_back({stage_, decimal(rho), known ? table_.plan.steps + offset : -1, relaxed});
  table_.places.push_back({table_.legs.size(), offset});
}

}  // namespace jam
