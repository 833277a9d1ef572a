// The energy ledger of the simulation (packing/packing.hpp says what each entry is).
#pragma once

#include "jamscape/observe/measure.hpp"

namespace jam {

/// kinetic + elastic + damped + rubbed - wall_work - gravity_work: constant along a run, to the integrator's order.
double ledger_sum(const EnergyLedger& energy);

Measure energy_measure();

}  // namespace jam
