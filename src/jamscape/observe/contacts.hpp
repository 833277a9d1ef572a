// Numbers of contacts and their mean normal force.
#pragma once

#include "jamscape/observe/measure.hpp"

namespace jam {

/// Mean over the network's edges of |sum of F_n n over the contacts of the pair|; 0 without edges.
double mean_normal_force(const Snapshot& snapshot);

Measure contacts_measure();

}  // namespace jam
