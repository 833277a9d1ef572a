// The packing without its rattlers: grains with fewer than two contacts (walls count) are taken out once, as in S2, not
// recursively, so chains stay.
//
//   z_backbone = 2 N_pp'/N'     N' grains that stay, N_pp' touching pairs of them
// Source: S2 Sec. 4; theory sec. 4.
#pragma once

#include "jamscape/observe/measure.hpp"

namespace jam {

struct Backbone {
  double z = 0;            ///< 0 where no grain stays
  std::size_t grains = 0;  ///< N'
};

Backbone backbone(const Packing& packing, const Bonds& bonds);

Measure backbone_measure();

}  // namespace jam
