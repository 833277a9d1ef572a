// Mean stress of the box from its contact forces (no kinetic part):
//
//   sigma_ab = (1/V) sum over grains, over their contacts, of f_a l_b,
//
// f the force on the grain, l from its centre to the contact point; wall contacts included. The two halves of a contact
// between grains add up to f_a (x_j - x_i)_b. Compression has a negative trace; pressure = -trace/D is positive then.
// V is the box Domain::lo..hi, or the cylinder in it. Every contact counts, several of two clusters each by itself. In
// static equilibrium V pressure = -(1/D) sum over wall contacts of f.p, p the contact point: pressure = wall_pressure
// for smooth flat walls; lower by order d/L for bead walls, whose contact points lie inside the square of bead-centre
// lines; lower too where rough walls carry part of the load along themselves. Off-diagonal elements are symmetrised by
// the measure (their difference is the net torque on the grains). Source: S3 Eq. 8; theory sec. 4.
#pragma once

#include <array>

#include "jamscape/observe/measure.hpp"

namespace jam {

/// sigma[a][b] as above, not symmetrised; zero for a box without volume.
std::array<Vec3, 3> stress(const Packing& packing);

Measure stress_measure();

}  // namespace jam
