// Six-fold bond orientation, bonds being contacts between grains (2D only; all are 0 in three dimensions).
//
//   psi6 (S1)    per grain, bond angles sorted in [-pi, pi): mean of cos 6 theta over the N_b - 1 gaps theta between
//                consecutive bonds, the gap across +-pi left out; then the mean over all grains
//   psi6_closed  the same over all N_b gaps
//   psi6_local   mean over all grains of |(1/N_b) sum_b exp(6 i theta_b)|
//   psi6_global  |mean over all grains of (1/N_b) sum_b exp(6 i theta_b)|
//
// A grain without bonds contributes 0 to all four, one with a single bond 0 to the first two, which are means over
// gaps, and 1 and exp(6 i theta) to the last two. A hexagonal lattice gives 1. The printed formula has no
// phase that could cancel: a square lattice gives -1, a straight chain +1, and a disordered packing nothing like 1/N.
// It also depends on the axis where the sorting starts. Source: S1 Sec. III.B; theory sec. 4.
#pragma once

#include "jamscape/observe/measure.hpp"

namespace jam {

struct BondOrder {
  double printed = 0, closed = 0, local = 0, global = 0;
};

BondOrder bond_order(const Packing& packing, const Bonds& bonds);

Measure bond_order_measure();

}  // namespace jam
