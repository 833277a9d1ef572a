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

inline WallTouch touch_wall(const ClusterWall& wall, const double* arm, int end) {
  const Segment<double> axis = axis_of(arm);
  const Vec3 tip = axis.centre + (end == 0 ? -axis.half_length : axis.half_length) * axis.direction;
  const double r = arm[3];
  WallTouch t{};
  if (wall.kind == WallKind::plane) {
    const double sign = wall.high ? -1.0 : 1.0;
    t.overlap = r - sign * (tip[wall.axis] - wall.position);
    t.normal[wall.axis] = -sign;
  } else {
    Vec3 out = tip - wall.centre;
    out[wall.axis] = 0;
    const double distance = norm(out);
    t.overlap = distance + r - wall.radius;
    t.normal = distance > 0 ? (1 / distance) * out : out;
  }
  t.point = tip + (r - t.overlap / 2) * t.normal;
  return t;
}

/// All ends nearer to a wall than `wall_skin` and the body's skin, springs taken over as in list_arm_pairs().
WallEnds list_wall_ends(const ClusterState& bodies, const std::vector<ClusterWall>& walls, double wall_skin,
                        const WallEnds& old, const std::vector<std::uint32_t>& old_arm_id);

}  // namespace jam
