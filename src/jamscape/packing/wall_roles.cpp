#include "jamscape/packing/wall_roles.hpp"

#include <cmath>

namespace jam {
namespace {

const Wall* guess_lid(const Packing& packing) {
  const bool falls = packing.energy.gravity_work != 0;
  for (std::size_t w = packing.walls.size(); w-- > 0;)
    if (falls && packing.walls[w].kind == WallKind::plane && wall_axis(packing.walls[w], packing.dimension) == 1)
      return &packing.walls[w];
  for (std::size_t w = packing.walls.size(); w-- > 0;)
    if (packing.walls[w].kind != WallKind::cylinder) return &packing.walls[w];
  return nullptr;
}

}  // namespace

int wall_axis(const Wall& wall, int dimension) {
  int axis = 0;
  for (int a = 1; a < dimension; ++a)
    if (std::abs(wall.normal[a]) > std::abs(wall.normal[axis])) axis = a;
  return axis;
}

void give_roles(Packing& packing, int axis) {
  for (Wall& wall : packing.walls) {
    const bool across = wall.kind != WallKind::cylinder && wall_axis(wall, packing.dimension) == axis;
    wall.role = !across ? WallRole::side : wall.normal[axis] > 0 ? WallRole::floor : WallRole::lid;
  }
}

void guess_roles(Packing& packing) {
  const Wall* lid = guess_lid(packing);
  if (lid == nullptr) return;
  const Vec3 down = lid->normal;
  const int axis = wall_axis(*lid, packing.dimension);
  for (Wall& wall : packing.walls) {
    const bool across = wall.kind != WallKind::cylinder && wall_axis(wall, packing.dimension) == axis;
    wall.role = &wall == lid ? WallRole::lid : across && dot(wall.normal, down) < 0 ? WallRole::floor : WallRole::side;
  }
}

const Wall* find_lid(const Packing& packing) {
  for (std::size_t w = packing.walls.size(); w-- > 0;)
    if (packing.walls[w].role == WallRole::lid) return &packing.walls[w];
  return nullptr;
}

}  // namespace jam
