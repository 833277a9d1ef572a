// Shape of P(f), the distribution of the contacts' normal forces (contact_forces.hpp): tail, laws, peak.
// stats/force_tail.hpp says how each is taken.
#pragma once

#include "jamscape/observe/measure.hpp"

namespace jam {

Measure force_tail_measure();

}  // namespace jam
