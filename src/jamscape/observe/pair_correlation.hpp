// Pair correlation g(r) of the grain centres, r in mean diameters (clusters: of the circumscribed spheres):
//
//   g(r) = n(r)/(N_ref(r) rho s(r)),   s = pi (r_2^2 - r_1^2) in 2D, 4 pi (r_2^3 - r_1^3)/3 in 3D,
//
// n(r) the grains in the shell r_1..r_2 about the N_ref(r) reference grains, rho the number density away from the
// walls. 1 for an ideal gas, at every distance and without edge correction: a reference grain counts at r only while
// its shell stays inside the box (r_2 <= its distance to every wall, less the wall's bead and half a grain, where no
// centres can be; r_2 <= half of every periodic length), and never when it is closer to a wall than the margin,
// where the wall orders the grains. The margin is at most a sixth of the width.
// S1 plots arbitrary units, and its 2 pi d Delta d N rho/2 counts each pair once, from any grain; this is the same
// function in absolute units. Bins without reference grains are NaN.
// Source: S1 Sec. III.B, Fig. 7; theory sec. 4.
#pragma once

#include <cstdint>
#include <vector>

#include "jamscape/observe/measure.hpp"

namespace jam {

struct PairCorrelation {
  std::vector<double> distance;  ///< centres of the bins, in mean diameters
  std::vector<double> g;
  std::vector<std::uint32_t> references;  ///< N_ref of each bin
};

/// Cost: linear in the number of grains for a given range.
PairCorrelation pair_correlation(const Packing& packing, const MeasureOptions& options);

Measure pair_correlation_measure();

}  // namespace jam
