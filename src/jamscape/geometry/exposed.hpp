// Which parts of a line or an arc other spherocylinders leave uncovered.
#pragma once

#include <span>
#include <vector>

#include "jamscape/geometry/cluster.hpp"

namespace jam {

struct Interval {
  double lo, hi;
};

/// The parts of x + s u, lo <= s <= hi, outside all `covers` (u a unit vector), in order.
std::vector<Interval> exposed_line(std::span<const Arm> covers, const Vec3& x, const Vec3& u, Interval range);

/// The parts of centre + radius (cos t e + sin t f), 0 <= t <= pi/2, outside all `covers` (e, f unit vectors at right
/// angles), in order.
std::vector<Interval> exposed_arc(std::span<const Arm> covers, const Vec3& centre, double radius, const Vec3& e,
                                  const Vec3& f);

/// Squared distance of a point to an arm's axis.
double axis_distance2(const Arm& arm, const Vec3& point);

}  // namespace jam
