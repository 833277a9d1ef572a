// The sides of the box: distances between opposite walls (bead-centre lines for bead walls) or periodic lengths.
#pragma once

#include "jamscape/observe/measure.hpp"

namespace jam {

/// Area (2D) or volume (3D) of Domain::lo..hi.
double box_volume(const Packing& packing);

Measure box_measure();

}  // namespace jam
