// How far the grains are from rest:
//
//   unbalanced_force = (mean over grains of |sum of the forces on it|)/(mean over contacts of |contact force|)
//
// The forces on a grain are those of its contacts, walls included, and its weight, m times `gravity` down the second
// axis. 0 in static equilibrium, about 1 while single collisions go on; missing without a contact that carries a force.
// The contacts are those of bonds.hpp, several of a pair each by itself.
#pragma once

#include "jamscape/observe/measure.hpp"

namespace jam {

double unbalanced_force(const Packing& packing, double gravity = 0);

Measure balance_measure();

}  // namespace jam
