// Runs one simulation: the stages of a system from its start (or a checkpoint) to its end, one frame after another.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "jamscape/base/archive.hpp"
#include "jamscape/dem/diverged.hpp"
#include "jamscape/packing/packing.hpp"
#include "jamscape/protocol/options.hpp"
#include "jamscape/protocol/state_axis.hpp"

namespace jam {

/// Raised whenever a change of the code changes the bits of a simulation of this kind; part of a task's hash.
///   1   discs, linear law
///   2   discs, Hertz laws, since the Coulomb limit is compared before the factor x^(1/2)
///   3   clusters in a container
///   4   discs enough for several parts (dem/parts.hpp)
///   5   spheres, since sums of products are rounded once (`fused` in dem/kernel.hpp)
///   7   other boxes that begin with steps or rest, since both begin at start.packing_fraction in every realisation
///   8   periodic boxes, since the start has no mean velocity, rest is judged by the forces too, and the dashpots feel
///       the box shrink
///   9   linear laws with friction and no tangential spring, since sliding is booked with the dashpot's power as it is
///       cut (the ledger alone)
///   10  boxes of flat walls faster than the grains at their start, since moving walls age the neighbour lists; with
///       what 7 says
int physics_revision(const SystemOptions& system);

/// What names the random numbers of one simulation.
struct TaskKey {
  std::uint64_t seed = 0;
  std::string system;
  std::uint64_t realisation = 0;
};

/// A frame the protocol will deliver, known before the simulation starts.
struct PlannedFrame {
  std::string stage;
  double packing_fraction = 0;  ///< as asked for; the frame is taken at the first step that reaches it. NaN in a
                                ///< container, where it is what comes out
  std::int64_t step = 0;        ///< -1 where it is not known before: after the first relaxation or press
  bool relaxed = false;         ///< taken at the end of a relaxation

  /// Is this the frame taken at `step` of `stage`? `found` is its packing fraction, `relaxation` Packing::relaxation.
  bool matches(std::int64_t at, const std::string& of, double found, const std::string& relaxation) const;
};

struct Plan {
  std::int64_t steps = 0;   ///< of the whole protocol; how long grains settle, relax and are pressed is guessed
  std::int64_t bodies = 0;  ///< grains
  double start = 0;         ///< packing fraction of the start, below start.packing_fraction where its lattice is wider;
                            ///< 0 in a container
  std::vector<PlannedFrame> frames;
  const StateAxis* axis = &planned_packing_fraction;  ///< what the frames go by
};

/// What the protocol will do; throws a usage error (with the option's key in its text) for a system that cannot be:
/// a stage that ends below the packing fraction it starts from, frames outside a stage, grains that do not fit.
Plan plan(const SystemOptions& system, const TaskKey& key);

struct Progress {
  std::int64_t step = 0, steps = 0;
  double packing_fraction = 0;
  std::string stage;
};

/// Called from the simulating thread.
struct Hooks {
  /// That share the steps of a large packing of discs or spheres (Engine::set_threads); no bit depends on them.
  int threads = 1;
  /// Steps between two looks at stop, checkpoint_due and progress; 0: by the clock, some times a second.
  std::int64_t look_every = 0;
  /// A frame whose ledger_error (protocol/ledger.hpp) is above this ends the run as diverged.
  double largest_ledger_error = 0.1;
  /// Every frame not taken before the checkpoint started from, in order; `index` counts from 0 over the whole plan.
  std::function<void(std::size_t index, const Packing&)> frame;
  /// Some times a second.
  std::function<void(const Progress&)> progress;
  /// Polled some times a second: true saves a checkpoint and ends the run.
  std::function<bool()> stop;
  /// Polled some times a second: true saves a checkpoint and goes on. Saving changes no bit of the simulation.
  std::function<bool()> checkpoint_due;
  /// Receives the complete state. Frames taken before it have been delivered before.
  std::function<void(const Archive&)> checkpoint;
};

enum class Outcome { finished, stopped };

/// Throws Diverged, and whatever a hook throws. `from` continues a simulation with the same bits as if it had never
/// been stopped; it throws a data error if it is not of this system.
Outcome simulate(const SystemOptions& system, const TaskKey& key, const Hooks& hooks, const Archive* from = nullptr);

}  // namespace jam
