#include "jamscape/dem/cluster_walls.hpp"

#include "jamscape/dem/cluster_list.hpp"

namespace jam {
namespace {

/// How far the body reaches towards the wall, or more: nothing to look for below -skin.
double nearest(const ClusterWall& wall, const double* row, double radius) {
  if (wall.kind == WallKind::plane) return radius - (wall.high ? -1.0 : 1.0) * (row[wall.axis] - wall.position);
  Vec3 out = vec3(row) - wall.centre;
  out[wall.axis] = 0;
  return norm(out) + radius - wall.radius;
}

}  // namespace

WallEnds list_wall_ends(const ClusterState& s, const std::vector<ClusterWall>& walls, double wall_skin,
                        const WallEnds& old, const std::vector<std::uint32_t>& old_arm_id) {
  SpringsByNumber kept(s.arm_count());
  const auto second = [](std::uint32_t wall, std::uint8_t end) { return 2 * wall + end; };
  for (std::size_t q = 0; q < old.size(); ++q)
    if (old.held[q]) kept.put(old_arm_id[old.arm[q]], second(old.wall[q], old.end[q]), old.spring[q]);
  kept.sort();
  WallEnds list;
  for (std::uint32_t w = 0; w < walls.size(); ++w)
    for (std::size_t k = 0; k < s.count(); ++k) {
      const double skin = wall_skin + s.skin[k];
      if (nearest(walls[w], s.row(k), s.radius[k]) <= -skin) continue;
      for (std::uint32_t a = s.first_arm[k]; a < s.first_arm[k + 1]; ++a)
        for (std::uint8_t end = 0; end < (s.arm(a)[7] > 0 ? 2 : 1); ++end) {
          if (wall_overlap(walls[w], s.arm(a), end) <= -skin) continue;
          const Vec3* spring = kept.find(s.arm_id[a], second(w, end));
          list.wall.push_back(w);
          list.arm.push_back(a);
          list.end.push_back(end);
          list.held.push_back(spring != nullptr);
          list.spring.push_back(spring ? *spring : Vec3{});
        }
    }
  return list;
}

}  // namespace jam
