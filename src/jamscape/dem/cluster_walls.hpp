// Walls around clusters: planes, and a hollow cylinder. Both sides of the contact are convex for an arm inside, so that
// its two end points say all (theory sec. 3).
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "jamscape/dem/cluster_bodies.hpp"
#include "jamscape/packing/packing.hpp"

namespace jam {

/// A plane across `axis` that moves along it, or a cylinder along `axis` at rest, the bodies inside.
struct ClusterWall {
  WallKind kind = WallKind::plane;
  int axis = 0;
  bool high = false;    ///< plane: at the upper end of the axis, bodies below it
  double position = 0;  ///< plane: along the axis
  double velocity = 0;  ///< plane: along the axis
  double radius = 0;    ///< cylinder
  Vec3 centre{};        ///< cylinder: a point of its axis
};

// An end may sink into a wall with its whole diameter: unlike between arms, the normal stays what it was when the axis
// gets there. An arm that carries much of the lid's load by itself does.

/// The ends of arms that may touch a wall before the list is made anew, by wall, arm and end.
struct WallEnds {
  std::vector<std::uint32_t> wall, arm;
  std::vector<std::uint8_t> end;   ///< 0: centre - h u, 1: centre + h u
  std::vector<std::uint8_t> held;  ///< touched at the last step
  std::vector<Vec3> spring;

  std::size_t size() const { return wall.size(); }
};

struct WallTouch {
  double overlap;
  Vec3 normal;  ///< towards the wall
  Vec3 point;   ///< half the overlap behind the surface of the arm
};

/// One coordinate of an end of an arm.
inline double tip(const double* arm, int end, int c) { return arm[c] + (end == 0 ? -arm[7] : arm[7]) * arm[4 + c]; }

/// Of an end with a wall; above 0 where they touch.
inline double wall_overlap(const ClusterWall& wall, const double* arm, int end) {
  const double r = arm[3];
  if (wall.kind == WallKind::plane) return r - (wall.high ? -1.0 : 1.0) * (tip(arm, end, wall.axis) - wall.position);
  Vec3 out;
  for (int c = 0; c < 3; ++c) out[c] = c == wall.axis ? 0 : tip(arm, end, c) - wall.centre[c];
  return norm(out) + r - wall.radius;
}

inline WallTouch touch_wall(const ClusterWall& wall, const double* arm, int end) {
  const Vec3 at{tip(arm, end, 0), tip(arm, end, 1), tip(arm, end, 2)};
  WallTouch t{};
  t.overlap = wall_overlap(wall, arm, end);
  if (wall.kind == WallKind::plane) {
    t.normal[wall.axis] = wall.high ? 1.0 : -1.0;
  } else {
    Vec3 out = at - wall.centre;
    out[wall.axis] = 0;
    const double distance = norm(out);
    t.normal = distance > 0 ? (1 / distance) * out : out;
  }
  t.point = at + (arm[3] - t.overlap / 2) * t.normal;
  return t;
}

/// All ends nearer to a wall than `wall_skin` and the body's skin, springs taken over as in list_arm_pairs().
WallEnds list_wall_ends(const ClusterState& bodies, const std::vector<ClusterWall>& walls, double wall_skin,
                        const WallEnds& old, const std::vector<std::uint32_t>& old_arm_id);

}  // namespace jam
