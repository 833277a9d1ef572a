#include "jamscape/observe/walls.hpp"

#include <algorithm>

#include "jamscape/observe/box.hpp"
#include "jamscape/observe/box_sides.hpp"
#include "jamscape/observe/entry.hpp"
#include "jamscape/observe/wall_margin.hpp"
#include "jamscape/packing/cell.hpp"

namespace jam {

namespace {

/// The normal force on each wall by its contacts away from the others; with no margin all of it.
std::vector<double> inner_forces(const Packing& p, const Bonds& bonds, const MeasureOptions& options) {
  std::vector<double> force(p.walls.size(), 0.0);
  const WallMargin margin(p, options);
  const Domain cell = reduced(p.domain, p.dimension);
  const Contacts& k = p.contacts;
  for (const std::uint32_t c : bonds.wall_contact) {
    const auto w = static_cast<std::size_t>(-1 - k.j[c]);
    const int axis = wall_axis(p.walls[w], p.dimension);
    Vec3 along = k.point[c];
    along[axis] = (cell.lo[axis] + cell.hi[axis]) / 2;
    if (margin.keeps(along))
      force[w] += dot(k.tangential_force[c] - k.normal_force[c] * k.normal[c], p.walls[w].normal);
  }
  return force;
}

double wall_virial(const Packing& p, const Bonds& bonds) {
  const Contacts& k = p.contacts;
  const Domain cell = reduced(p.domain, p.dimension);
  const Vec3 centre = 0.5 * (cell.lo + cell.hi);
  double sum = 0;
  for (const std::uint32_t c : bonds.wall_contact)
    sum += dot(k.tangential_force[c] - k.normal_force[c] * k.normal[c], k.point[c] - centre);
  const double volume = box_volume(p);
  const auto walled = std::count(cell.periodic.begin(), cell.periodic.begin() + p.dimension, false);
  return volume > 0 && walled > 0 ? (0 - sum) / (static_cast<double>(walled) * volume) : 0;
}

}  // namespace

WallForces wall_forces(const Packing& packing, const Bonds& bonds, const MeasureOptions& options) {
  WallForces f;
  const Domain cell = reduced(packing.domain, packing.dimension);
  const Vec3 side = cell.hi - cell.lo;
  const double volume = box_volume(packing);
  const bool whole = options.force_margin == 0;
  const WallMargin margin(packing, options);
  const std::vector<double> inner = whole ? std::vector<double>() : inner_forces(packing, bonds, options);
  double sum = 0, walls = 0;
  for (std::size_t w = 0; w < packing.walls.size(); ++w) {
    const Wall& wall = packing.walls[w];
    if (wall.kind == WallKind::cylinder) continue;
    const int at = wall_side(wall, packing.dimension);
    const double force = -dot(wall.force, wall.normal);
    f.normal[static_cast<std::size_t>(at)] += force;
    double area = volume / side[at / 2];
    for (int a = 0; a < packing.dimension; ++a)
      if (a != at / 2) area *= 1 - 2 * margin.along(a) / side[a];
    area *= margin.round_share();  // of a floor or lid
    if (volume > 0) sum += (whole ? force : inner[w]) / area;
    ++walls;
  }
  if (walls > 0) f.pressure = sum / walls;
  if (!packing.walls.empty()) f.virial = wall_virial(packing, bonds);
  return f;
}

Measure walls_measure() {
  const char* unit = "m d/tau_c^2";
  return frame_measure(
      {"walls", "forces on the walls",
       "wall_force = -F.n with F the force of all grains on a wall and n its normal into the domain: positive when the "
       "wall is pushed outward. wall_pressure: mean over the walls of force over length (area) between the lines of "
       "bead centres of its neighbours; with force_margin > 0 contacts closer than that to another wall are left out "
       "and the lengths are shorter by twice as much. wall_virial_pressure = -(1/(D V)) sum over wall contacts of f.(p "
       "- centre), f the force on the grain, p the contact point, V as for stress, centre the middle of the box, D the "
       "number of axes that are not periodic: at "
       "rest and without gravity the pressure of the measure stress. wall_pressure is larger by what walls hand to "
       "each other in the corners and along themselves, and as bead contacts lie inside the lines of centres. Walls "
       "that are not there have force 0; a cylinder, whose sum over all directions says nothing, is left out of "
       "wall_pressure. Missing where walls stand around a tilted cell, unless it stands for the same space as an "
       "upright "
       "one.",
       "theory sec. 1"},
      {{"wall_force_x_lo", unit, "normal force on the wall at small x"},
       {"wall_force_x_hi", unit, "normal force on the wall at large x"},
       {"wall_force_y_lo", unit, "normal force on the wall at small y"},
       {"wall_force_y_hi", unit, "normal force on the wall at large y"},
       {"wall_force_z_lo", unit, "normal force on the wall at small z; 0 in two dimensions"},
       {"wall_force_z_hi", unit, "normal force on the wall at large z; 0 in two dimensions"},
       {"wall_pressure", "m d^(2-D)/tau_c^2", "mean of force over length (area) of the walls; 0 without walls"},
       {"wall_virial_pressure", "m d^(2-D)/tau_c^2", "pressure by the moments of the wall forces; 0 without walls"}},
      [](const Snapshot& s) {
        const WallForces f = wall_forces(s.packing(), s.bonds(), s.options());
        std::vector<double> row(f.normal.begin(), f.normal.end());
        row.push_back(f.pressure);
        row.push_back(f.virial);
        return row;
      },
      {.upright_walls = true});
}

}  // namespace jam
