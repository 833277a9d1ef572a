// What a protocol drives: grains in an engine, and the walls around them. A driver is one engine with one kind of
// walls; the protocol knows no more of them than stands here, and asks as often as it likes: no question changes a bit.
#pragma once

#include <cstdint>
#include <memory>

#include "jamscape/base/archive.hpp"
#include "jamscape/contact/law.hpp"
#include "jamscape/packing/packing.hpp"
#include "jamscape/protocol/plan.hpp"

namespace jam {

class Driver {
 public:
  virtual ~Driver() = default;

  /// Sets the walls in motion for this leg.
  virtual void begin(const Leg& leg) = 0;
  /// Steps until this one. Throws Diverged.
  virtual void run_to(std::int64_t step) = 0;
  virtual std::int64_t step() const = 0;
  /// The wall of a press leg carries its force.
  virtual bool reached(const Leg& leg) = 0;

  /// This instant in full, packing fractions included. Throws Diverged.
  virtual Packing record() = 0;
  /// Translation and rotation.
  virtual double kinetic_energy() const = 0;
  /// Of all contacts.
  virtual ElasticEnergy elastic_energy() const = 0;
  /// How far the packing is from balance (unbalanced.hpp).
  virtual double unbalanced() = 0;
  /// In the study's convention.
  virtual double packing_fraction() const = 0;

  /// Everything that determines what follows, bit for bit.
  virtual void save(Archive& archive) const = 0;
  /// Throws a data error for an archive of another system.
  virtual void load(const Archive& archive) = 0;

  /// Shares the steps among threads, as many as are of use; returns how many that are. No bit depends on them.
  virtual int set_threads(int wanted) = 0;
  /// Grain-steps between two glances at the clock: about a millisecond.
  virtual double work_per_glance() const = 0;
};

/// At the start of the protocol. Throws a usage error for a system that cannot be.
std::unique_ptr<Driver> make_driver(const SystemOptions& system, const TaskKey& key);

/// What set_threads() would return, without making the start.
int threads_of_use(const SystemOptions& system, int wanted);

}  // namespace jam
