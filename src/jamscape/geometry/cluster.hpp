// Rigid clusters of spherocylinders: rods, crosses, stars, or any arrangement of arms. A sphere is an arm of no length.
#pragma once

#include <string>
#include <vector>

#include "jamscape/geometry/vec.hpp"

namespace jam {

/// A spherocylinder: all points within `radius` of the segment centre +- half_length direction.
struct Arm {
  Vec3 centre{};
  Vec3 direction{1, 0, 0};  ///< unit vector
  double half_length = 0;   ///< of the axis: (L - d) / 2
  double radius = 0.5;      ///< d / 2
  bool operator==(const Arm&) const = default;
};

/// The union of its arms, in its own frame: centre of mass at the origin, principal axes along x, y, z (a shape for two
/// dimensions keeps its plane: z is the axis it turns about). Lengths for size factor 1; a body of size factor s has
/// s^3 times the volume and mass and s^5 times the inertia. Overlap of arms counts once.
struct ClusterShape {
  std::string name;  ///< "sphere", "rod", "cross", "star", "custom"
  std::vector<Arm> arms;
  double volume = 0;
  double surface = 0;
  double area = 0;          ///< of the shadow along z: what two dimensions see
  Vec3 inertia{};           ///< integral of y^2 + z^2, z^2 + x^2, x^2 + y^2 over the volume (density 1)
  double length = 0;        ///< L: the longest arm, tip to tip
  double circumradius = 0;  ///< from the centre of mass to the farthest point
  bool operator==(const ClusterShape&) const = default;
};

/// pi^(1/3) (6 V)^(2/3) / A: 1 for a sphere. Source: S3, theory sec. 2.6.
double sphericity(const ClusterShape& shape);

}  // namespace jam
