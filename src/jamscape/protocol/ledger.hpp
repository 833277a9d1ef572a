// By how much a simulation makes or loses energy (theory sec. 2.5):
//
//   ledger_error = |ledger_sum - E_0| / (E_0 + |wall_work| + |gravity_work| + |damped| + |rubbed|)
//
// E_0 is the kinetic energy of the start. What stands below the line is what was turned over: the energy the grains
// had, what walls and gravity put in, and what dashpots and friction took. From rest E_0 is nothing and the first touch
// puts in next to nothing; below the line E_0 counts at least as much as the grains have when they move with the walls.
#pragma once

#include "jamscape/packing/packing.hpp"
#include "jamscape/protocol/options.hpp"
#include "jamscape/protocol/simulate.hpp"

namespace jam {

struct LedgerStart {
  double energy = 0;  ///< E_0, with which the ledger begins
  double scale = 0;   ///< E_0 below the line
};

/// `kinetic` is that of the start.
LedgerStart ledger_start(const SystemOptions& system, double kinetic);

/// The same from the options alone. Makes the start; costs as much as a few steps.
LedgerStart ledger_start(const SystemOptions& system, const TaskKey& key);

/// `turned_over` is that of EnergyLedger. 0 where nothing is off, infinite where a sum is no number.
double ledger_error(double ledger_sum, double turned_over, const LedgerStart& start);

/// Throws Diverged where the error is above `largest`, so that the integrator makes energy: long before grains fly
/// apart, and where they never do because friction caps the forces that a dashpot too stiff for the time step feeds
/// back.
void check_ledger(const Packing& packing, const LedgerStart& start, double largest,
                  const IntegratorOptions& integrator);

}  // namespace jam
