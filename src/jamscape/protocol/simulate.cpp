#include "jamscape/protocol/simulate.hpp"

#include <algorithm>
#include <chrono>
#include <memory>

#include "jamscape/base/error.hpp"
#include "jamscape/base/flush_to_zero.hpp"
#include "jamscape/protocol/driver.hpp"
#include "jamscape/protocol/ledger.hpp"
#include "jamscape/protocol/plan.hpp"
#include "jamscape/protocol/relaxation.hpp"

namespace jam {
namespace {

class Run {
 public:
  Run(const SystemOptions& system, const TaskKey& key, const Hooks& hooks)
      : system_(system), key_(key), hooks_(hooks), table_(timetable(system, key)) {
    driver_->set_threads(hooks.threads);
  }

  Outcome go(const Archive* from) {
    from ? resume(*from) : begin_leg(0);
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds between_looks{250};
    const std::int64_t look =
        hooks_.look_every > 0
            ? hooks_.look_every
            : std::max<std::int64_t>(
                  1, static_cast<std::int64_t>(driver_->work_per_glance() / static_cast<double>(system_.grains.count)));
    Clock::time_point due = Clock::now() + between_looks;
    for (std::int64_t next_look = driver_->step() + look;;) {
      take_frames_and_turn();
      if (leg_ == table_.legs.size()) return Outcome::finished;
      driver_->run_to(std::min(next_look, next_event()));
      if (driver_->step() < next_look) continue;
      next_look = driver_->step() + look;
      if (hooks_.look_every == 0) {  // steps may take a thousand times as long as they did
        if (Clock::now() < due) continue;
        due = Clock::now() + between_looks;
      }
      if (hooks_.progress)
        hooks_.progress({driver_->step(), std::max(expected_steps(), driver_->step() + 1), driver_->packing_fraction(),
                         table_.legs[leg_].stage});
      const bool stop = hooks_.stop && hooks_.stop();
      if (hooks_.checkpoint && (stop || (hooks_.checkpoint_due && hooks_.checkpoint_due()))) hooks_.checkpoint(save());
      if (stop) return Outcome::stopped;
    }
  }

 private:
  void begin_leg(std::size_t leg) {
    enter_leg(leg, driver_->step());
    if (leg < table_.legs.size()) driver_->begin(table_.legs[leg]);
  }

  void enter_leg(std::size_t leg, std::int64_t begin) {
    leg_ = leg, leg_begin_ = begin;
    pressed_ = false;
    if (leg < table_.legs.size() && table_.legs[leg].kind == LegKind::relax)
      relaxation_ = Relaxation(table_.legs[leg].relax);
  }

  /// Everything that happens at this step before the clock goes on: a sample of the energies, frames, the next leg.
  void take_frames_and_turn() {
    watch();
    while (leg_ < table_.legs.size()) {
      const bool known = table_.legs[leg_].kind == LegKind::move;
      if (known && leg_over())
        begin_leg(leg_ + 1);
      else if (frame_due())
        deliver_frame();
      else if (!known && leg_over())  // its frame is taken before the walls change their motion
        begin_leg(leg_ + 1);
      else
        return;
    }
    while (frame_due()) deliver_frame();
  }

  bool leg_over() const {
    switch (table_.legs[leg_].kind) {
      case LegKind::relax:
        return !relaxation_.ended().empty();
      case LegKind::press:
        return pressed_;
      case LegKind::move:
        break;
    }
    return driver_->step() >= leg_begin_ + table_.legs[leg_].steps;
  }

  bool frame_due() const {
    if (next_frame_ == table_.places.size()) return false;
    const auto& place = table_.places[next_frame_];
    if (place.leg != leg_) return place.leg < leg_;
    return table_.legs[leg_].kind != LegKind::move ? leg_over() : driver_->step() >= leg_begin_ + place.offset;
  }

  /// Looks whether a leg of unknown length is over.
  void watch() {
    if (leg_ == table_.legs.size() || leg_over()) return;
    const Leg& leg = table_.legs[leg_];
    if (leg.kind == LegKind::press) pressed_ = driver_->reached(leg);
    if (leg.kind != LegKind::relax || driver_->step() < leg_begin_ + relaxation_.next_sample()) return;
    double elastic = 0;
    if (relaxation_.wants_elastic()) {
      const ElasticEnergy e = driver_->elastic_energy();
      elastic = e.normal + e.tangential;
    }
    relaxation_.add_sample(driver_->kinetic_energy(), elastic);
    if (relaxation_.wants_forces()) relaxation_.judge_forces(driver_->unbalanced());
  }

  /// The next step at which something happens.
  std::int64_t next_event() const {
    const Leg& leg = table_.legs[leg_];
    if (leg.kind == LegKind::press) return driver_->step() + 1;  // watched after every step
    if (leg.kind == LegKind::relax) return leg_begin_ + relaxation_.next_sample();
    std::int64_t next = leg_begin_ + leg.steps;
    if (next_frame_ < table_.places.size() && table_.places[next_frame_].leg == leg_)
      next = std::min(next, leg_begin_ + table_.places[next_frame_].offset);
    return next;
  }

  /// Of the whole protocol, as far as it can be known now.
  std::int64_t expected_steps() const {
    std::int64_t steps = driver_->step();
    if (leg_ < table_.legs.size()) steps = std::max(steps, leg_begin_ + table_.legs[leg_].steps);
    for (std::size_t l = leg_ + 1; l < table_.legs.size(); ++l) steps += table_.legs[l].steps;
    return steps;
  }

  void deliver_frame() {
    Packing packing = driver_->record();
    check_ledger(packing, ledger_start_, hooks_.largest_ledger_error, system_.integrator);
    packing.stage = table_.plan.frames[next_frame_].stage;
    if (table_.plan.frames[next_frame_].relaxed) packing.relaxation = relaxation_.ended();
    if (hooks_.frame) hooks_.frame(next_frame_, packing);
    ++next_frame_;
  }

  Archive save() const {
    Archive archive;
    driver_->save(archive);
    archive["protocol/system"] = key_.system;
    archive["protocol/counters"] = std::vector<std::int64_t>{physics_revision(system_),
                                                             static_cast<std::int64_t>(key_.seed),
                                                             static_cast<std::int64_t>(key_.realisation),
                                                             static_cast<std::int64_t>(next_frame_),
                                                             static_cast<std::int64_t>(leg_),
                                                             leg_begin_};
    archive["protocol/relaxation"] = relaxation_.save();
    return archive;
  }

  void resume(const Archive& archive) {
    const auto* n = find_entry<std::vector<std::int64_t>>(archive, "protocol/counters");
    const auto* s = find_entry<std::string>(archive, "protocol/system");
    const auto* r = find_entry<std::vector<double>>(archive, "protocol/relaxation");
    if (!n || n->size() != 6 || !s || !r || *s != key_.system || (*n)[0] != physics_revision(system_) ||
        (*n)[1] != static_cast<std::int64_t>(key_.seed) || (*n)[2] != static_cast<std::int64_t>(key_.realisation) ||
        (*n)[4] < 0 || static_cast<std::size_t>((*n)[4]) >= table_.legs.size())
      throw data_error("the checkpoint belongs to another task or another version of the physics", {},
                       "delete it; the task then starts from its beginning");
    driver_->load(archive);
    next_frame_ = static_cast<std::size_t>((*n)[3]);
    enter_leg(static_cast<std::size_t>((*n)[4]), (*n)[5]);
    if (table_.legs[leg_].kind == LegKind::relax) relaxation_.load(*r);
  }

  const SystemOptions& system_;
  const TaskKey& key_;
  const Hooks& hooks_;
  Timetable table_;
  std::unique_ptr<Driver> driver_ = make_driver(system_, key_);
  LedgerStart ledger_start_ = ledger_start(system_, driver_->kinetic_energy());
  std::size_t next_frame_ = 0, leg_ = 0;
  std::int64_t leg_begin_ = 0;
  Relaxation relaxation_;
  bool pressed_ = false;
};

}  // namespace

Outcome simulate(const SystemOptions& system, const TaskKey& key, const Hooks& hooks, const Archive* from) {
  const FlushToZero guard;
  return Run(system, key, hooks).go(from);
}

}  // namespace jam
