// Packing fraction and box length, in the conventions of theory sec. 6a.
#pragma once

#include "jamscape/protocol/options.hpp"

namespace jam {

/// What the packing fraction of a square (cubic) box of length L is made of: rho(L) = grains / volume(L).
/// Length unit: mean grain diameter d; beads have diameter 1.
struct BoxMeasure {
  int dimension = 2;
  WallModel walls = WallModel::beads;
  BoxConvention convention = BoxConvention::half_beads;
  double grains = 0;  ///< grain area (volume) in the study's convention
  double plain = 0;   ///< the true sum

  /// Area (volume) of a box of side L; for bead walls L is the distance between the lines of bead centres.
  double volume(double length) const;
  double packing_fraction(double length) const { return grains / volume(length); }
  double packing_fraction_plain(double length) const { return plain / volume(length); }
  /// The L at which the packing fraction has this value.
  double length(double packing_fraction) const;
};

}  // namespace jam
