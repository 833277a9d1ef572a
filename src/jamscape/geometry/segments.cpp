#include "jamscape/geometry/segments.hpp"

namespace jam {

double axis_distance(const Arm& one, const Arm& two) {
  const Segment<double> a{one.centre, one.direction, one.half_length}, b{two.centre, two.direction, two.half_length};
  return std::sqrt(closest_points(a, b).distance2);
}

}  // namespace jam
