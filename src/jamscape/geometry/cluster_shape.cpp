#include "jamscape/geometry/cluster_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "jamscape/base/error.hpp"
#include "jamscape/geometry/arm_union.hpp"
#include "jamscape/geometry/arrange.hpp"

namespace jam {
namespace {

using std::numbers::pi;
using std::numbers::sqrt2;

/// Integral of one coordinate squared over the volume.
struct SecondMoments {
  double x, y, z;
};

Vec3 inertia_of(const SecondMoments& m) { return {m.y + m.z, m.z + m.x, m.x + m.y}; }

// Of a spherocylinder of radius r, half length h, and of what two or three of them share where they cross (h >= r).
double arm_volume(double h, double r) { return 2 * pi * r * r * h + 4 * pi / 3 * r * r * r; }
double arm_surface(double h, double r) { return 4 * pi * r * h + 4 * pi * r * r; }
double arm_shadow(double h, double r) { return 4 * r * h + pi * r * r; }
double along_arm(double h, double r) {
  const double r2 = r * r;
  return 2 * pi * r2 * (h * h * h / 3 + h * h * r * 2 / 3 + h * r2 / 2 + 2 * r2 * r / 15);
}
double across_arm(double h, double r) { return std::pow(r, 4) * (pi * h / 2 + 4 * pi * r / 15); }
double two_along(double r) { return 64.0 / 45 * std::pow(r, 5); }
double two_across(double r) { return 16.0 / 15 * std::pow(r, 5); }
double three_any(double r) { return 4 * (44 - 23 * sqrt2) / 45 * std::pow(r, 5); }

void check_aspect(const char* name, double aspect) {
  if (aspect >= 1 && std::isfinite(aspect)) return;
  throw usage_error(fmt::format("aspect ratio {} of a {}: an arm is at least as long as it is thick", aspect, name), {},
                    "give L/d of at least 1");
}

ClusterShape crossed_arms(const char* name, double aspect, int count) {
  check_aspect(name, aspect);
  const double r = 0.5, h = (aspect - 1) / 2;
  std::vector<Arm> arms;
  for (int k = 0; k < (h > 0 ? count : 1); ++k) {
    Arm arm{.half_length = h, .radius = r};
    arm.direction = {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0};
    arms.push_back(arm);
  }
  ClusterShape shape = arranged(name, std::move(arms));
  const double along = along_arm(h, r), across = across_arm(h, r);
  if (shape.arms.size() == 1) {
    shape.volume = arm_volume(h, r);
    shape.surface = arm_surface(h, r);
    shape.area = arm_shadow(h, r);
    shape.inertia = inertia_of({along, across, across});
  } else if (h >= r) {
    const bool star = count == 3;
    const double r2 = r * r, r3 = r2 * r, all = 8 * (2 - sqrt2);  // the three arms share all r^3
    shape.volume = count * arm_volume(h, r) - (star ? 3 : 1) * 16 * r3 / 3 + (star ? all * r3 : 0);
    shape.surface = count * arm_surface(h, r) - (star ? 3 : 1) * 16 * r2 + (star ? 3 * all * r2 : 0);
    shape.area = 2 * arm_shadow(h, r) - 4 * r2;  // a star's third arm stands in the shadow of the others
    if (star) {
      const double any = along + 2 * across - 2 * two_along(r) - two_across(r) + three_any(r);
      shape.inertia = inertia_of({any, any, any});
    } else {
      const double in_plane = along + across - two_along(r);
      shape.inertia = inertia_of({in_plane, in_plane, 2 * across - two_across(r)});
    }
  } else {
    const UnionIntegrals sum = integrate_union(shape.arms);
    shape.volume = sum.volume;
    shape.surface = sum.surface;
    shape.area = shadow_area(shape.arms);
    const double in_plane = (sum.second[0][0] + sum.second[1][1]) / 2;  // equal by symmetry
    const double any = (2 * in_plane + sum.second[2][2]) / 3;
    shape.inertia = count == 3 ? inertia_of({any, any, any}) : inertia_of({in_plane, in_plane, sum.second[2][2]});
  }
  return shape;
}

}  // namespace

double sphericity(const ClusterShape& shape) {
  return std::cbrt(pi) * std::pow(6 * shape.volume, 2.0 / 3) / shape.surface;
}

double aspect_ratio(const ClusterShape& shape) {
  double radius = 0;
  for (const Arm& arm : shape.arms) radius = std::max(radius, arm.radius);
  return shape.length / (2 * radius);
}

ClusterShape sphere_shape() { return crossed_arms("sphere", 1, 1); }
ClusterShape rod_shape(double aspect) { return crossed_arms("rod", aspect, 1); }
ClusterShape cross_shape(double aspect) { return crossed_arms("cross", aspect, 2); }
ClusterShape star_shape(double aspect) { return crossed_arms("star", aspect, 3); }

Distances contact_distances(const ClusterShape& shape) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (shape.name != "cross" && shape.name != "star") return {unknown, unknown, unknown, unknown};
  const double d = 1 / aspect_ratio(shape);  // in units of L
  const double d1 = std::hypot(d, (1 + d) / 2);
  return {d1, 2 * d1, 3 * d1, std::sqrt(3.0) * d};
}

}  // namespace jam
