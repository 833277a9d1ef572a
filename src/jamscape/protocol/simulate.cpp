#include "jamscape/protocol/simulate.hpp"

#include <algorithm>
#include <cmath>

#include "jamscape/base/error.hpp"
#include "jamscape/base/flush_to_zero.hpp"
#include "jamscape/dem/engine.hpp"
#include "jamscape/protocol/plan.hpp"
#include "jamscape/protocol/start.hpp"

namespace jam {
namespace {

/// Between two looks at the hooks: grain-steps, some tenths of a second.
constexpr double work_per_look = 8e6;

template <int D>
class Run {
 public:
  Run(const SystemOptions& system, const TaskKey& key, const Hooks& hooks)
      : system_(system), key_(key), hooks_(hooks), table_(timetable(system, key)), engine_(start<D>(system, key)) {}

  Outcome go(const Archive* from) {
    if (from) resume(*from);
    const std::int64_t look =
        hooks_.look_every > 0
            ? hooks_.look_every
            : std::max<std::int64_t>(
                  1, static_cast<std::int64_t>(work_per_look / static_cast<double>(system_.grains.count)));
    enter_stage();
    for (std::int64_t next_look = engine_.step() + look;;) {
      const bool frame_due =
          next_frame_ < table_.plan.frames.size() && table_.plan.frames[next_frame_].step == engine_.step();
      if (frame_due) deliver_frames();
      if (engine_.step() >= table_.plan.steps) return Outcome::finished;
      // A frame leaves the forces summed; only advance() may follow.
      if (frame_due) engine_.advance();
      std::int64_t until = std::min(next_look, stage_end());
      if (next_frame_ < table_.plan.frames.size()) until = std::min(until, table_.plan.frames[next_frame_].step);
      engine_.run(until - engine_.step());
      enter_stage();
      if (engine_.step() < next_look) continue;
      next_look = engine_.step() + look;
      if (hooks_.progress)
        hooks_.progress({engine_.step(), table_.plan.steps, table_.box.packing_fraction(length()), stage_name()});
      const bool stop = hooks_.stop && hooks_.stop();
      if (hooks_.checkpoint && (stop || (hooks_.checkpoint_due && hooks_.checkpoint_due()))) hooks_.checkpoint(save());
      if (stop) return Outcome::stopped;
    }
  }

 private:
  std::size_t stage() const {
    std::size_t s = 0;
    while (s + 1 < table_.stages.size() && engine_.step() >= table_.stages[s + 1].first) ++s;
    return s;
  }
  std::string stage_name() const { return table_.stages[stage()].name; }
  std::int64_t stage_end() const { return table_.stages[stage()].first + table_.stages[stage()].steps; }

  double length() const {
    if (engine_.walls().empty()) return engine_.box().length[0];
    return engine_.walls()[1].position - engine_.walls()[0].position;
  }

  /// Sets the walls to the speed of the stage the clock is in.
  void enter_stage() {
    const double speed = table_.stages[stage()].speed;
    for (std::size_t w = 0; w < engine_.walls().size(); ++w) {
      const double v = engine_.walls()[w].high ? -speed : speed;
      if (engine_.walls()[w].velocity != v) engine_.set_wall_velocity(w, v);
    }
    if (engine_.walls().empty()) engine_.set_box_speed(speed);
  }

  void deliver_frames() {
    engine_.compute_forces();
    Packing packing = engine_.record();
    packing.packing_fraction = table_.box.packing_fraction(length());
    packing.packing_fraction_plain = table_.box.packing_fraction_plain(length());
    const auto& frames = table_.plan.frames;
    for (; next_frame_ < frames.size() && frames[next_frame_].step == engine_.step(); ++next_frame_) {
      packing.stage = frames[next_frame_].stage;
      if (hooks_.frame) hooks_.frame(next_frame_, packing);
    }
  }

  Archive save() const {
    Archive archive;
    engine_.save(archive);
    archive["protocol/system"] = key_.system;
    archive["protocol/counters"] =
        std::vector<std::int64_t>{physics_revision, static_cast<std::int64_t>(key_.seed),
                                  static_cast<std::int64_t>(key_.realisation), static_cast<std::int64_t>(next_frame_)};
    return archive;
  }

  void resume(const Archive& archive) {
    const auto name = archive.find("protocol/system"), counters = archive.find("protocol/counters");
    const auto* n = counters == archive.end() ? nullptr : std::get_if<std::vector<std::int64_t>>(&counters->second);
    const auto* s = name == archive.end() ? nullptr : std::get_if<std::string>(&name->second);
    if (!n || n->size() != 4 || !s || *s != key_.system || (*n)[0] != physics_revision ||
        (*n)[1] != static_cast<std::int64_t>(key_.seed) || (*n)[2] != static_cast<std::int64_t>(key_.realisation))
      throw data_error("the checkpoint belongs to another task or another version of the physics", {},
                       "delete it; the task then starts from its beginning");
    engine_.load(archive);
    next_frame_ = static_cast<std::size_t>((*n)[3]);
  }

  const SystemOptions& system_;
  const TaskKey& key_;
  const Hooks& hooks_;
  Timetable table_;
  Engine<D> engine_;
  std::size_t next_frame_ = 0;
};

}  // namespace

Outcome simulate(const SystemOptions& system, const TaskKey& key, const Hooks& hooks, const Archive* from) {
  const FlushToZero guard;
  return system.domain.dimension == 2 ? Run<2>(system, key, hooks).go(from) : Run<3>(system, key, hooks).go(from);
}

}  // namespace jam
