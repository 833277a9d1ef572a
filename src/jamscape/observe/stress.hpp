// Mean stress of the box from its contact forces (no kinetic part):
//
//   sigma_ab = (1/V) sum over grains, over their contacts, of f_a l_b,
//
// f the force on the grain, l from its centre to the contact point; wall contacts included. The two halves of a contact
// between grains add up to f_a (x_j - x_i)_b. Compression has a negative trace; pressure = -trace/D is positive then.
// V is the box Domain::lo..hi: for bead walls the square of bead-centre lines, larger than the region of the contact
// points by the beads' depth, so that a static packing has pressure = wall_pressure to order d/L only; with flat walls
// exactly. Off-diagonal elements are symmetrised (their difference is the net torque on the grains).
// Source: S3 Eq. 8; PHYSICS sec. 4.
#pragma once

#include <array>

#include "jamscape/observe/measure.hpp"

namespace jam {

/// sigma[a][b] as above, not symmetrised; zero for a box without volume.
std::array<Vec3, 3> stress(const Packing& packing);

Measure stress_measure();

}  // namespace jam
