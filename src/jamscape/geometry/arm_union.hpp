// Volume, surface and moments of a union of spherocylinders, overlap counted once, to about 1e-9 of the whole.
//
// Everything follows from the part of each arm's boundary that no other arm covers (x from the origin, n outwards):
//   V = 1/3 int x.n dA,   int x_i dV = 1/4 int x_i x.n dA,   int x_i x_j dV = 1/5 int x_i x_j x.n dA   (divergence
//   theorem).
// A plane through an arm's axis cuts its boundary in straight lines and arcs; what another arm covers of a line is one
// interval, known exactly, and of an arc some intervals, found to round-off. What is left is one integral over the
// angle of that plane, done by halving until it stands still. Where two boundaries coincide the first arm owns them.
#pragma once

#include <vector>

#include "jamscape/geometry/cluster.hpp"

namespace jam {

struct UnionIntegrals {
  double surface = 0;
  double volume = 0;
  Vec3 first{};              ///< int x dV
  double second[3][3] = {};  ///< int x_i x_j dV
};
UnionIntegrals integrate_union(const std::vector<Arm>& arms);

/// The area of the shadow of the arms along z.
double shadow_area(const std::vector<Arm>& arms);

}  // namespace jam
