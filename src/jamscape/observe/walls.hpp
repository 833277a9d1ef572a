// What the grains do to the walls: the normal force on each, and its mean over the length (area) of the walls.
//
//   wall_force = -F.n, F the force of the grains on the wall, n its normal into the domain: positive when pushed
//   outward wall_pressure = mean over the walls of wall_force/(length of the wall between its neighbours)
//
// A wall is known by the direction of its normal; a cylinder is left out: its forces cancel. Walls that are not there
// (periodic sides, z in 2D) have force 0.
#pragma once

#include <array>

#include "jamscape/observe/measure.hpp"

namespace jam {

struct WallForces {
  std::array<double, 6> normal{};  ///< x lo, x hi, y lo, y hi, z lo, z hi
  double pressure = 0;             ///< 0 without walls
};

WallForces wall_forces(const Packing& packing);

Measure walls_measure();

}  // namespace jam
