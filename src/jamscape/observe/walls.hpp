// What the grains do to the walls: the normal force on each, and its mean over the length (area) of the walls.
//
//   wall_force = -F.n, F the force of the grains on the wall, n its normal into the domain: positive when pushed
//   outward wall_pressure = mean over the walls of wall_force/(length of the wall between its neighbours)
//
//   wall_virial_pressure = -(1/(D V)) sum over wall contacts of f.(p - centre),  f on the grain, p the contact point
//
// The virial of the wall forces is the pressure of the measure `stress` in static equilibrium without gravity, exactly.
// wall_pressure is larger: contact points with beads lie inside the line of their centres, by up to d of L; and what a
// wall hands to its neighbour through a grain in the corner, or along itself by friction and between its beads, pushes
// both walls and presses no grain of the inside. force_margin leaves the corners out.
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
  double virial = 0;               ///< the pressure by the same forces' moments; 0 without walls
};

/// Contacts closer than options.force_margin to another wall are left out of `pressure`, whose lengths are shortened by
/// twice as much.
WallForces wall_forces(const Packing& packing, const Bonds& bonds, const MeasureOptions& options = {});

Measure walls_measure();

}  // namespace jam
