#include "jamscape/observe/box.hpp"

#include <cmath>
#include <numbers>

#include "jamscape/observe/entry.hpp"
#include "jamscape/packing/cell.hpp"
#include "jamscape/stats/none.hpp"

namespace jam {

const Wall* find_cylinder(const Packing& packing) {
  for (const Wall& wall : packing.walls)
    if (wall.kind == WallKind::cylinder) return &wall;
  return nullptr;
}

int height_axis(const Packing& packing) {
  const Wall* lid = find_lid(packing);
  return lid != nullptr ? wall_axis(*lid, packing.dimension) : packing.dimension - 1;
}

Vec3 box_sides(const Packing& packing) {
  const Domain cell = reduced(packing.domain, packing.dimension);
  if (cell.upright()) return cell.hi - cell.lo;
  const auto& t = packing.domain.tilt;  // triangular: what a sheared box is
  if (t[0] == Vec3{} && t[1][2] == 0) return packing.domain.hi - packing.domain.lo;
  return {none, none, none};
}

double box_volume(const Packing& packing) {
  const Wall* cylinder = find_cylinder(packing);
  if (cylinder == nullptr) return cell_volume(packing.domain, packing.dimension);
  const Vec3 side = packing.domain.hi - packing.domain.lo;
  return std::numbers::pi * cylinder->radius * cylinder->radius * side[wall_axis(*cylinder, packing.dimension)];
}

Measure box_measure() {
  return frame_measure(
      {"box", "sides of the box",
       "distances between opposite walls (between the lines of bead centres for bead walls), or periodic lengths; of a "
       "cylinder, of the box around it. Of a tilted cell whose first edge lies along x and whose second in the plane "
       "of x and y (a sheared box) the length of the first, and the heights of the second along y and of the third "
       "along z; of other tilted cells missing, unless they stand for the same lattice as an upright one.",
       "theory sec. 1, 6a"},
      {{"box_lx", "d", "along x"}, {"box_ly", "d", "along y"}, {"box_lz", "d", "along z; 0 in two dimensions"}},
      [](const Snapshot& s) {
        const Packing& p = s.packing();
        const Vec3 side = box_sides(p);
        return std::vector<double>{side[0], side[1], p.dimension == 3 ? side[2] : 0.0};
      });
}

}  // namespace jam
