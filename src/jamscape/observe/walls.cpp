#include "jamscape/observe/walls.hpp"

#include "jamscape/observe/box.hpp"
#include "jamscape/observe/box_sides.hpp"
#include "jamscape/observe/entry.hpp"

namespace jam {

WallForces wall_forces(const Packing& packing) {
  WallForces f;
  const Vec3 side = packing.domain.hi - packing.domain.lo;
  const double volume = box_volume(packing);
  double sum = 0, walls = 0;
  for (const Wall& wall : packing.walls) {
    if (wall.kind == WallKind::cylinder) continue;
    const int at = wall_side(wall, packing.dimension);
    const double force = -dot(wall.force, wall.normal);
    f.normal[static_cast<std::size_t>(at)] += force;
    if (volume > 0) sum += force / (volume / side[at / 2]);
    ++walls;
  }
  if (walls > 0) f.pressure = sum / walls;
  return f;
}

Measure walls_measure() {
  const char* unit = "m d/tau_c^2";
  return frame_measure(
      {"walls", "forces on the walls",
       "wall_force = -F.n with F the force of all grains on a wall and n its normal into the domain: positive when the "
       "wall is pushed outward. wall_pressure: mean over the walls of force over length (area). Walls that are not "
       "there "
       "have force 0; a cylinder, whose sum over all directions says nothing, is left out.",
       "theory sec. 1"},
      {{"wall_force_x_lo", unit, "normal force on the wall at small x"},
       {"wall_force_x_hi", unit, "normal force on the wall at large x"},
       {"wall_force_y_lo", unit, "normal force on the wall at small y"},
       {"wall_force_y_hi", unit, "normal force on the wall at large y"},
       {"wall_force_z_lo", unit, "normal force on the wall at small z; 0 in two dimensions"},
       {"wall_force_z_hi", unit, "normal force on the wall at large z; 0 in two dimensions"},
       {"wall_pressure", "m d^(2-D)/tau_c^2", "mean of force over length (area) of the walls; 0 without walls"}},
      [](const Snapshot& s) {
        const WallForces f = wall_forces(s.packing());
        std::vector<double> row(f.normal.begin(), f.normal.end());
        row.push_back(f.pressure);
        return row;
      });
}

}  // namespace jam
