// Runs of LAMMPS for lammps_test: a sheared packing of spheres between flat walls.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "lammps_state.hpp"

namespace jam::lammps {

struct ContactForce {
  double normal;
  Vec3 tangential;  ///< on the first grain
};

/// What one run left behind. Grains by number.
struct Followed {
  State<3> start;
  std::vector<Vec3> position, velocity, spin, force, torque;  ///< after the steps
  /// By (i, j), i < j, or (i, -1 - w) at wall w: 0 below, 1 above.
  std::map<std::pair<int, int>, ContactForce> contacts;
};

/// Makes the packing in a folder of this name, emptied first. Throws std::runtime_error with the log's end if LAMMPS
/// fails.
class Packed {
 public:
  explicit Packed(const std::string& name);
  Followed follow(double dt, int steps) const;

 private:
  std::string folder_;
};

}  // namespace jam::lammps
