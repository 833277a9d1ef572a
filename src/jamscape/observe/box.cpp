#include "jamscape/observe/box.hpp"

#include "jamscape/observe/entry.hpp"

namespace jam {

double box_volume(const Packing& packing) {
  const Vec3 side = packing.domain.hi - packing.domain.lo;
  return side[0] * side[1] * (packing.dimension == 3 ? side[2] : 1.0);
}

Measure box_measure() {
  return frame_measure(
      {"box", "sides of the box",
       "distances between opposite walls (between the lines of bead centres for bead walls), or periodic "
       "lengths",
       "theory sec. 1, 6a"},
      {{"box_lx", "d", "along x"}, {"box_ly", "d", "along y"}, {"box_lz", "d", "along z; 0 in two dimensions"}},
      [](const Snapshot& s) {
        const Packing& p = s.packing();
        const Vec3 side = p.domain.hi - p.domain.lo;
        return std::vector<double>{side[0], side[1], p.dimension == 3 ? side[2] : 0.0};
      });
}

}  // namespace jam
