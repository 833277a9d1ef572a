// The space the grains are in: distances between opposite walls (bead-centre lines for bead walls) or periodic lengths,
// the cylinder around them, the lid on top.
#pragma once

#include "jamscape/observe/measure.hpp"
#include "jamscape/packing/wall_roles.hpp"

namespace jam {

/// The cylinder around the grains; none: null.
const Wall* find_cylinder(const Packing& packing);

/// The axis of the lid, from floor to top; the last axis without a lid.
int height_axis(const Packing& packing);

/// Lengths of the cell along the axes, the same for every cell of a lattice; not a number for tilted cells that have
/// none.
Vec3 box_sides(const Packing& packing);

/// Area (2D) or volume (3D) of the cell, or of the cylinder between its ends.
double box_volume(const Packing& packing);

Measure box_measure();

}  // namespace jam
