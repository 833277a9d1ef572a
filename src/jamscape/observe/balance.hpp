// How far the grains are from rest:
//
//   unbalanced_force = (mean over grains of |sum of its contact forces|)/(mean over contacts of |contact force|),
//
// wall contacts included on both sides, contact forces only: 0 in static equilibrium (under gravity the weight of a grain
// over the mean contact force), about 1 while single collisions go on; 0 without contacts.
#pragma once

#include "jamscape/observe/measure.hpp"

namespace jam {

double unbalanced_force(const Packing& packing);

Measure balance_measure();

}  // namespace jam
