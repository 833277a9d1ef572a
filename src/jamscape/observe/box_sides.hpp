// Which sides of the box the grains touch: what percolation needs to know of walls and periodic sides.
#pragma once

#include <vector>

#include "jamscape/network/level_sweep.hpp"
#include "jamscape/observe/force_network.hpp"
#include "jamscape/packing/packing.hpp"

namespace jam {

/// The side of the box a wall stands on (a cylinder stands on none), by the direction of its normal: 2 axis, or 2 axis
/// + 1 for the high side.
int wall_side(const Wall& wall, int dimension);

/// Of each grain the sides whose wall it touches: wall contacts of positive normal force.
std::vector<Sides> touched_sides(const Packing& packing, const Bonds& bonds);

/// The same of each vertex of the network.
std::vector<Sides> sides_of_vertices(const ForceNetwork& network, std::vector<Sides> sides_of_grains);

/// Of each edge the periodic copy of its second grain; empty where no side is periodic.
std::vector<BoxCopy> edge_images(const Packing& packing, const ForceNetwork& network);

/// The edges of the cell for BoxSides; of an upright one along the axes.
std::array<std::array<double, 3>, 3> cell_edges(const Domain& cell);

}  // namespace jam
