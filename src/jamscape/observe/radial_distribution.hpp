// Radial distribution G(r) of the bodies' centres as S3 has it, r in L (bodies.hpp):
//
//   G(r) = pairs/ideal,   pairs  bodies in the shell r..r + Delta r about all reference bodies
//                         ideal  N_ref rho_N times the shell: 2 pi r Delta r (2D), 4 pi r^2 Delta r (3D), rho_N =
//                         N/volume
//
// 1 for an ideal gas. References stay away from the walls by margins of their own from the ends (lid and floor), the
// sides, and a cylinder; a margin that would leave less than a quarter of the width gives way to a sixth of the width.
// A reference counts at r only while its shell stays inside the walls, so `references` may fall with r. In three
// dimensions the sides of a slab too thin for whole shells (width < 2 range) have no margin, and the ideal gas counts
// the part of the shell between them. pair_correlation.hpp is S1's function: other margins, density away from the
// walls. Source: S3 Eqs. 9, 10, corrected; theory sec. 4.
#pragma once

#include <array>
#include <vector>

#include "jamscape/observe/measure.hpp"
#include "jamscape/stats/resampling.hpp"

namespace jam {

struct RadialDistribution {
  double length = 0;                              ///< L, in d
  double margin_ends = 0, margin_sides = 0;       ///< used, in L; 0 where there are no walls
  std::vector<double> distance;                   ///< centres of the bins, in L
  std::vector<std::vector<double>> pairs, ideal;  ///< [reference][bin]; 0 beyond a reference's reach

  std::vector<double> sum(const std::vector<std::vector<double>>& counts) const;  ///< over the references
};

/// Cost: linear in the number of bodies for a given range.
RadialDistribution radial_distribution(const Packing& packing, const MeasureOptions& options);

Measure radial_distribution_measure();
Measure rdf_peaks_measure();

}  // namespace jam
