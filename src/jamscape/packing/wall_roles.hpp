// Which wall is the floor, and which the lid.
#pragma once

#include "jamscape/packing/packing.hpp"

namespace jam {

/// The axis a wall's normal is along; of a cylinder, its own.
int wall_axis(const Wall& wall, int dimension);

/// Planes and rows across `axis` become floor (normal up) and lid (normal down); all other walls are sides.
void give_roles(Packing& packing, int axis);

/// For packings whose walls do not say: the lid is the last wall that is no cylinder; where gravity has done work the
/// last plane across the second axis, if there is one. The floor is opposite.
void guess_roles(Packing& packing);

/// The last wall that is a lid; null without.
const Wall* find_lid(const Packing& packing);

}  // namespace jam
