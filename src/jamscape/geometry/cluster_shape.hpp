// Shapes by name and from arms: sphere, rod, cross, star, or any connected arrangement of spherocylinders. Lengths in
// d, the diameter of an arm; the aspect ratio is L/d >= 1, L an arm from tip to tip. Closed forms for spheres, rods and
// L/d >= 2, an integral over the exposed boundary else, good to about 1e-9. Source: S3, theory sec. 2.6.
#pragma once

#include <vector>

#include "jamscape/geometry/cluster.hpp"

namespace jam {

ClusterShape sphere_shape();
/// One arm along x.
ClusterShape rod_shape(double aspect);
/// Two arms along x and y, sharing their centre. At L/d = 1 the arms coincide, and one is kept.
ClusterShape cross_shape(double aspect);
/// Three arms along x, y and z, sharing their centre. At L/d = 1 the arms coincide, and one is kept.
ClusterShape star_shape(double aspect);

/// A shape of these arms, moved so that its centre of mass is the origin, and turned to its principal axes by the
/// smallest rotation (in two dimensions about z only). Directions need not have unit length. Throws jam::Error (usage)
/// for arms that do not form one body (touching is not enough), radii or lengths out of range, directions of no length
/// and, in two dimensions, arms out of the plane z = 0.
ClusterShape custom_shape(std::vector<Arm> arms, int dimension);

/// L/d: `length` in diameters of the thickest arm.
double aspect_ratio(const ClusterShape& shape);

/// Distances between the centres of neighbours in the closest configurations of S3, in units of L. NaN for shapes other
/// than crosses and stars.
struct Distances {
  double d1;  ///< two, arms in each other's corner: sqrt(d^2 + ((L + d) / 2)^2) / L (Eq. 11)
  double d2;  ///< 2 d1
  double d3;  ///< 3 d1
  double j1;  ///< stars nested along the space diagonal: sqrt(3) d / L (Eq. 12)
};
Distances contact_distances(const ClusterShape& shape);

}  // namespace jam
