#include "jamscape/observe/box.hpp"

#include <cmath>
#include <numbers>

#include "jamscape/observe/entry.hpp"

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

double box_volume(const Packing& packing) {
  const Vec3 side = packing.domain.hi - packing.domain.lo;
  if (const Wall* cylinder = find_cylinder(packing))
    return std::numbers::pi * cylinder->radius * cylinder->radius * side[wall_axis(*cylinder, packing.dimension)];
  return side[0] * side[1] * (packing.dimension == 3 ? side[2] : 1.0);
}

Measure box_measure() {
  return frame_measure(
      {"box", "sides of the box",
       "distances between opposite walls (between the lines of bead centres for bead walls), or periodic lengths; of a "
       "cylinder, of the box around it",
       "theory sec. 1, 6a"},
      {{"box_lx", "d", "along x"}, {"box_ly", "d", "along y"}, {"box_lz", "d", "along z; 0 in two dimensions"}},
      [](const Snapshot& s) {
        const Packing& p = s.packing();
        const Vec3 side = p.domain.hi - p.domain.lo;
        return std::vector<double>{side[0], side[1], p.dimension == 3 ? side[2] : 0.0};
      });
}

}  // namespace jam
