// The energy ledger of the simulation (packing/packing.hpp says what each entry is).
#pragma once

#include "jamscape/observe/measure.hpp"

namespace jam {

Measure energy_measure();

}  // namespace jam
