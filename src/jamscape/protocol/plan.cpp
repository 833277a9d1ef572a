#include "jamscape/protocol/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "jamscape/base/error.hpp"
#include "jamscape/protocol/cluster_start.hpp"
#include "jamscape/protocol/start.hpp"

namespace jam {
namespace {

std::string number(double a) {
  std::string s = std::to_string(a);
  s.erase(s.find_last_not_of('0') + 1);
  return s.back() == '.' ? s + "0" : s;
}

/// The decimal number that was meant where arithmetic left the last digits of one (.68 for .6799999999999999).
double decimal(double a) {
  const double meant = std::strtod(fmt::format("{:.12g}", a).c_str(), nullptr);
  return std::abs(meant - a) <= 8 * std::numeric_limits<double>::epsilon() * std::abs(a) ? meant : a;
}

/// Three digits, rounded down.
std::string below(double a) { return fmt::format("{}", decimal(std::floor(a * 1000) / 1000)); }

/// Kinetic energies level off within two windows; where only their size counts, the budget is what most runs need.
std::int64_t guess_relaxation(const RelaxOptions& o) {
  const double windows = o.fluctuation > 0 ? std::min(2.0, o.windows) : o.windows;
  return static_cast<std::int64_t>(windows * static_cast<double>(o.window));
}

/// Steps until walls that close in with `rate` per step have taken `travel`; rounding never adds a step.
std::int64_t steps_for(double travel, double rate) {
  return std::max<std::int64_t>(0, static_cast<std::int64_t>(std::ceil(travel / rate - 1e-6)));
}

[[noreturn]] void refuse_kind(const StageOptions& stage, const std::string& name, const char* where,
                              const char* kinds) {
  std::string kind;
  for (const auto& [value, text] : EnumNames<StageKind>::values)
    if (value == stage.kind) kind = text;
  throw usage_error("stage." + name + ".kind: there is no stage \"" + kind + "\" in " + where, {}, kinds);
}

void refuse_frames(const StageOptions& stage, const std::string& name) {
  if (stage.frames > 0 || !stage.frames_at.empty())
    throw usage_error("stage." + name + (stage.frames > 0 ? ".frames" : ".frames_at") +
                          ": only stages of kind = \"compress\" have it",
                      {}, stage.kind == StageKind::steps ? "frames_inside" : "this stage has one frame, at its end");
}

/// Appends legs and frames of a box that shrinks, stage after stage.
class BoxWriter {
 public:
  /// Stages count from start.packing_fraction where the lattice of this realisation begins below it, too: frames and
  /// steps lie on one grid in all realisations, and the first stage closes the rest of the way by itself.
  BoxWriter(const StartBox& box, const SystemOptions& system)
      : dt_(system.integrator.step), box_(box.measure), length_(box.length), reached_(system.start.packing_fraction) {
    table.plan.start = box_.packing_fraction(length_);
    for (const StageOptions& stage : system.stages)
      if (speed_ == 0 && stage.kind != StageKind::relax) speed_ = stage.speed;
  }

  Timetable table;

  void write(const StageOptions& stage, const std::string& name) {
    stage_ = &stage, name_ = name;
    if (stage.kind == StageKind::settle || stage.kind == StageKind::press)
      refuse_kind(stage, name, "a box that shrinks", "domain.walls = \"box\" or \"cylinder\" is a container");
    if (stage.kind != StageKind::compress) refuse_frames(stage, name);
    if (stage.kind == StageKind::relax) return relax();
    const double fraction = box_.packing_fraction(length_);
    if (fraction > stage.to + 1e-9 || (reached_ > stage.to + 1e-9 && (!at_start() || on_grid(stage))))
      throw usage_error("stage." + name + ".to = " + number(stage.to) + " is below the packing fraction " +
                            number(fraction > stage.to + 1e-9 ? fraction : reached_) + " the stage starts from",
                        {},
                        fraction > stage.to + 1e-9 ? "a larger `to`, or a smaller start.packing_fraction"
                                                   : "a larger `to`, or start.packing_fraction = " + below(fraction) +
                                                         ", which the start reaches");
    stage.kind == StageKind::steps ? climb() : compress(stage.to, frames_of_compression());
  }

  /// A run that no frame was asked of has its last instant.
  void finish() {
    if (!table.plan.frames.empty() || table.legs.empty()) return;
    table.plan.frames.push_back({name_, decimal(reached_), clock_known_ ? table.plan.steps : -1, false});
    table.places.push_back({table.legs.size() - 1, table.legs.back().steps});
  }

 private:
  bool at_start() const { return table.legs.empty(); }
  /// Frames or steps are counted from where the stage begins.
  static bool on_grid(const StageOptions& stage) { return stage.kind == StageKind::steps || stage.frames > 1; }

  /// The packing fractions of the frames of a compress stage, in order.
  std::vector<double> frames_of_compression() const {
    std::vector<double> at;
    const double from = std::min(reached_, stage_->to), to = stage_->to;
    const double lowest = std::min(from, box_.packing_fraction(length_));
    for (std::int64_t f = 0; f < stage_->frames; ++f)
      at.push_back(stage_->frames == 1
                       ? to
                       : from + (to - from) * static_cast<double>(f) / static_cast<double>(stage_->frames - 1));
    for (const double rho : stage_->frames_at) {
      if (rho < lowest - 1e-9 || rho > to + 1e-9)
        throw usage_error("stage." + name_ + ".frames_at: " + number(rho) +
                              " lies outside the stage, which goes from " + number(lowest) + " to " + number(to),
                          {}, "only packing fractions between the two");
      at.push_back(rho);
    }
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end(), [](double a, double b) { return b - a < 1e-9; }), at.end());
    return at;
  }

  void compress(double to, const std::vector<double>& frames) { compress(to, frames, stage_->speed); }

  void compress(double to, const std::vector<double>& frames, double speed) {
    const double closing = 2 * speed * dt_;
    const std::int64_t steps = steps_for(length_ - box_.length(to), closing);
    for (const double rho : frames)
      add_frame(rho, std::min(steps, steps_for(length_ - box_.length(rho), closing)), false);
    table.legs.push_back({name_, LegKind::move, speed, steps});
    table.plan.steps += steps;
    length_ -= closing * static_cast<double>(steps);
    reached_ = to;
  }

  void relax() {
    if (at_start() && reached_ > box_.packing_fraction(length_) + 1e-9) {
      if (speed_ > 0)
        compress(reached_, {}, speed_);
      else
        reached_ = box_.packing_fraction(length_);
    }
    add_frame(reached_, 0, true);
    const std::int64_t guess = guess_relaxation(stage_->relax);
    Leg leg{name_, LegKind::relax, 0, guess, stage_->relax};
    if (leg.relax.unbalanced < 0) leg.relax.unbalanced = box_.walls == WallModel::periodic ? balanced : 0;
    table.legs.push_back(leg);
    table.plan.steps += guess;
    clock_known_ = false;
  }

  void climb() {
    const auto rungs = static_cast<std::int64_t>(std::floor((stage_->to - reached_) / stage_->increment - 1e-6));
    for (std::int64_t rung = std::max<std::int64_t>(rungs, 0); rung >= 0; --rung) {
      const double from = reached_, to = stage_->to - static_cast<double>(rung) * stage_->increment;
      std::vector<double> inside;
      for (std::int64_t f = 1; f <= stage_->frames_inside; ++f)
        inside.push_back(from + (to - from) * static_cast<double>(f) / static_cast<double>(stage_->frames_inside));
      compress(to, inside);
      relax();
    }
  }

  void add_frame(double rho, std::int64_t offset, bool relaxed) {
    const bool known = clock_known_ && !relaxed;
    if (!relaxed && !table.places.empty() && table.places.back().leg == table.legs.size() &&
        table.places.back().offset == offset)
      refuse_one_step(rho);
    table.plan.frames.push_back({name_, decimal(rho), known ? table.plan.steps + offset : -1, relaxed});
    table.places.push_back({table.legs.size(), offset});
  }

  [[noreturn]] void refuse_one_step(double rho) const {
    const double rise = rho - box_.packing_fraction(box_.length(rho) + 2 * stage_->speed * dt_);
    const double from = std::min(table.plan.frames.back().packing_fraction, reached_);
    const auto most = static_cast<std::int64_t>((stage_->to - from) / (2 * rise)) + 1;
    throw usage_error(
        "stage." + name_ + ".frames: those at " + fmt::format("{:.6g}", table.plan.frames.back().packing_fraction) +
            " and " + fmt::format("{:.6g}", rho) + " fall into one time step, in which the packing fraction rises by " +
            fmt::format("{:.2g}", rise),
        {},
        fmt::format("frames = {} or fewer, speed = {:.1g}, or a shorter integrator.step",
                    std::max<std::int64_t>(most, 2),
                    stage_->speed * (rho - table.plan.frames.back().packing_fraction) / (2 * rise)));
  }

  static constexpr double balanced = 0.01;  ///< unbalanced part of a packing at rest

  double dt_;
  BoxMeasure box_;
  double length_, reached_;
  double speed_ = 0;         ///< of the first stage that moves
  bool clock_known_ = true;  ///< no relaxation so far
  const StageOptions* stage_ = nullptr;
  std::string name_;
};

/// Appends legs and frames of a container, stage after stage. What its packing fraction will be is not known before.
class ContainerWriter {
 public:
  ContainerWriter(const SystemOptions& system, double height) : system_(system), height_(height) {}

  Timetable table;

  void write(const StageOptions& stage, const std::string& name) {
    if (stage.kind == StageKind::compress || stage.kind == StageKind::steps)
      refuse_kind(stage, name, "a container", "settle, press and relax");
    refuse_frames(stage, name);
    Leg leg{name};
    const double dt = system_.integrator.step;
    if (stage.kind == StageKind::settle) {
      const double g = system_.domain.gravity;
      if (!(g > 0))
        throw usage_error("stage." + name + ".kind: nothing settles without gravity", {},
                          "domain.gravity = \"9.81 m/s^2\"");
      const double time = stage.settle_times * std::sqrt(2 * height_ / g);
      leg.steps = steps_for(time, dt);
      if (stage.settle_until == SettleUntil::rest) {
        leg.kind = LegKind::relax;
        leg.relax = stage.relax;
        leg.relax.fluctuation = 0;
        leg.relax.windows = static_cast<double>(leg.steps) / static_cast<double>(stage.relax.window);
        leg.steps = std::min(leg.steps, steps_for(falls_to_rest * std::sqrt(2 * height_ / g), dt));
        clock_known_ = false;
      }
    } else if (stage.kind == StageKind::press) {
      if (!(stage.force > 0))
        throw usage_error("stage." + name + ".force: the lid needs a force to stop at", {}, "force = \"500 N\"");
      leg.kind = LegKind::press;
      leg.speed = stage.speed;
      leg.force = stage.force;
      leg.steps = steps_for(lid_travel * height_, stage.speed * dt);
      clock_known_ = false;
    } else {
      leg.kind = LegKind::relax;
      leg.relax = stage.relax;
      leg.steps = guess_relaxation(stage.relax);
      clock_known_ = false;
    }
    const std::int64_t end = table.plan.steps + leg.steps;
    table.plan.frames.push_back(
        {name, std::numeric_limits<double>::quiet_NaN(), clock_known_ ? end : -1, stage.kind == StageKind::relax});
    table.places.push_back({table.legs.size(), leg.steps});
    table.plan.steps = end;
    table.legs.push_back(leg);
  }

 private:
  // Guesses, from S3's systems (validation/): at rest after 1.2 to 1.6 times the fall (nearly round stars in a cylinder
  // never are, and take the budget); the lid goes .001 to .03 of the height.
  static constexpr double falls_to_rest = 1.3, lid_travel = 0.01;

  const SystemOptions& system_;
  double height_;
  bool clock_known_ = true;
};

/// Neighbours are looked for in cells a little wider than the largest grain; across a periodic box there are three.
void check_width(const SystemOptions& system, const BoxMeasure& box, double largest) {
  constexpr double thin = 0.01, thick = 0.3;  // what a cell is wider, by the speed of the grains
  double to = 0;
  for (const StageOptions& stage : system.stages)
    if (stage.kind == StageKind::compress || stage.kind == StageKind::steps) to = std::max(to, stage.to);
  if (to == 0 || box.length(to) >= 3 * (largest + thin)) return;
  const double count = static_cast<double>(system.grains.count) *
                       std::pow(3 * (largest + thick) / box.length(to), static_cast<double>(system.domain.dimension));
  throw usage_error(
      fmt::format("grains.count = {}: the periodic box is {:.3g} d wide at packing fraction {}, less than "
                  "three of the largest grains ({:.3g} d), so that one could touch another on both sides",
                  system.grains.count, box.length(to), to, largest),
      {}, fmt::format("grains.count = {:.0f}, or walls", std::ceil(count)));
}

template <class Writer>
Timetable write_all(Writer writer, const SystemOptions& system) {
  writer.table.plan.bodies = system.grains.count;
  for (std::size_t s = 0; s < system.stages.size(); ++s) writer.write(system.stages[s], stage_name(system, s));
  if constexpr (requires { writer.finish(); }) writer.finish();
  return writer.table;
}

}  // namespace

Timetable timetable(const SystemOptions& system, const TaskKey& key) {
  if (system.stages.empty())
    throw usage_error("the study has no stage", {}, "add a [[stage]] table, e.g. kind = \"compress\", to = 0.9");
  if (is_container(system.domain.walls))
    return write_all(ContainerWriter(system, cluster_room(system, key).height), system);
  const std::vector<double> diameters = draw_diameters(system.grains, key);
  const StartBox box = start_box(system, diameters);
  if (system.domain.walls == WallModel::periodic)
    check_width(system, box.measure, *std::max_element(diameters.begin(), diameters.end()));
  return write_all(BoxWriter(box, system), system);
}

Plan plan(const SystemOptions& system, const TaskKey& key) { return timetable(system, key).plan; }

bool PlannedFrame::matches(std::int64_t at, const std::string& of, double found, const std::string& relaxation) const {
  if (step >= 0) return at == step;
  if (of != stage || relaxed != !relaxation.empty()) return false;
  return std::isnan(packing_fraction) || std::abs(found - packing_fraction) < 1e-3;  // fast walls overshoot
}

}  // namespace jam
