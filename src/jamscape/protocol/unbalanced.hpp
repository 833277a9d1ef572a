// How far a packing is from balance, as a relaxation judges it:
//
//   (mean over grains of |sum of contact forces + weight|)/(mean over contacts of |contact force|)
//
// wall contacts included on both sides; 0 without contacts.
#pragma once

#include "jamscape/packing/packing.hpp"

namespace jam {

/// `gravity` is the acceleration down the second axis.
double unbalanced_part(const Packing& packing, double gravity);

}  // namespace jam
