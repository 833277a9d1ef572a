#include "jamscape/protocol/plan.hpp"

#include <algorithm>
#include <cmath>

#include "jamscape/base/error.hpp"
#include "jamscape/protocol/start.hpp"

namespace jam {
namespace {

std::string number(double a) {
  std::string s = std::to_string(a);
  s.erase(s.find_last_not_of('0') + 1);
  return s.back() == '.' ? s + "0" : s;
}

/// Steps until walls that close in with `rate` per step have taken `travel`; rounding never adds a step.
std::int64_t steps_for(double travel, double rate) {
  return std::max<std::int64_t>(0, static_cast<std::int64_t>(std::ceil(travel / rate - 1e-6)));
}

/// Appends legs and frames, stage after stage.
class Writer {
 public:
  Writer(const StartBox& box, double dt) : dt_(dt), length_(box.length) {
    table.box = box.measure;
    reached_ = table.box.packing_fraction(length_);
  }

  Timetable table;

  void write(const StageOptions& stage, const std::string& name) {
    stage_ = &stage, name_ = name;
    if (stage.kind != StageKind::compress && (stage.frames > 0 || !stage.frames_at.empty()))
      throw usage_error("stage." + name + (stage.frames > 0 ? ".frames" : ".frames_at") +
                            ": only stages of kind = \"compress\" have it",
                        {},
                        stage.kind == StageKind::steps ? "frames_inside" : "a relax stage has one frame, at its end");
    if (stage.kind == StageKind::relax) return relax();
    if (reached_ > stage.to + 1e-9)
      throw usage_error("stage." + name + ".to = " + number(stage.to) + " is below the packing fraction " +
                            number(reached_) + " the stage starts from",
                        {}, "a larger `to`, or a smaller start.packing_fraction");
    stage.kind == StageKind::steps ? climb() : compress(stage.to, frames_of_compression());
  }

 private:
  /// The packing fractions of the frames of a compress stage, in order.
  std::vector<double> frames_of_compression() const {
    std::vector<double> at;
    const double from = std::min(reached_, stage_->to), to = stage_->to;
    for (std::int64_t f = 0; f < stage_->frames; ++f)
      at.push_back(stage_->frames == 1
                       ? to
                       : from + (to - from) * static_cast<double>(f) / static_cast<double>(stage_->frames - 1));
    for (const double rho : stage_->frames_at) {
      if (rho < from - 1e-9 || rho > to + 1e-9)
        throw usage_error("stage." + name_ + ".frames_at: " + number(rho) +
                              " lies outside the stage, which goes from " + number(from) + " to " + number(to),
                          {}, "only packing fractions between the two");
      at.push_back(rho);
    }
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end(), [](double a, double b) { return b - a < 1e-9; }), at.end());
    return at;
  }

  void compress(double to, const std::vector<double>& frames) {
    const double closing = 2 * stage_->speed * dt_;
    const std::int64_t steps = steps_for(length_ - table.box.length(to), closing);
    for (const double rho : frames)
      add_frame(rho, std::min(steps, steps_for(length_ - table.box.length(rho), closing)), false);
    table.legs.push_back({name_, false, stage_->speed, steps, {}});
    table.plan.steps += steps;
    length_ -= closing * static_cast<double>(steps);
    reached_ = to;
  }

  void relax() {
    add_frame(reached_, 0, true);
    const std::int64_t guess =
        static_cast<std::int64_t>(std::min(2.0, stage_->relax.windows) * static_cast<double>(stage_->relax.window));
    table.legs.push_back({name_, true, 0, guess, stage_->relax});
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
    table.plan.frames.push_back({name_, rho, known ? table.plan.steps + offset : -1, relaxed});
    table.places.push_back({table.legs.size(), offset});
  }

  double dt_, length_, reached_ = 0;
  bool clock_known_ = true;  ///< no relaxation so far
  const StageOptions* stage_ = nullptr;
  std::string name_;
};

}  // namespace

Timetable timetable(const SystemOptions& system, const TaskKey& key) {
  if (system.stages.empty())
    throw usage_error("the study has no stage", {}, "add a [[stage]] table, e.g. kind = \"compress\", to = 0.9");
  Writer writer(start_box(system, draw_diameters(system.grains, key)), system.integrator.step);
  writer.table.plan.bodies = system.grains.count;
  for (std::size_t s = 0; s < system.stages.size(); ++s) writer.write(system.stages[s], stage_name(system, s));
  return writer.table;
}

Plan plan(const SystemOptions& system, const TaskKey& key) { return timetable(system, key).plan; }

bool PlannedFrame::matches(std::int64_t at, const std::string& of, double found, const std::string& relaxation) const {
  if (step >= 0) return at == step;
  return of == stage && relaxed == !relaxation.empty() &&
         std::abs(found - packing_fraction) < 1e-3;  // fast walls overshoot
}

}  // namespace jam
