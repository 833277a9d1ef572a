// The same impacts in LAMMPS: each body a rigid clump of overlapping spheres along its arms (fix rigid/small), with the
// mass, the centre and the inertia of the true body given to it, so that only the surface is rough.
#pragma once

#include <string>

#include "impacts.hpp"

namespace jam::clusters {

/// `name`: of the folder for LAMMPS's files, emptied first. `spheres`: on each arm, evenly from end to end. Throws
/// std::runtime_error if LAMMPS fails.
Motion collide_clumps(const std::string& name, const Impacts& impacts, const Law& law, int spheres, double dt,
                      int steps);

}  // namespace jam::clusters
