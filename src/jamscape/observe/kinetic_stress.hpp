// Stress of the grains' motion, which the contact stress (stress.hpp) leaves out:
//
//   sigma_ab = -(1/V) sum over grains of m (v - <v>)_a (v - <v>)_b,      <v> = (sum m v)/(sum m)
//
// over the same V, negative trace too; kinetic_pressure = -trace/D is to be added to `pressure` while grains move.
// Rotation has no part in it. Source: theory sec. 4.
#pragma once

#include <array>

#include "jamscape/observe/measure.hpp"

namespace jam {

/// Zero for a box without volume.
std::array<Vec3, 3> kinetic_stress(const Packing& packing);

Measure kinetic_stress_measure();

}  // namespace jam
