// What follows of a shape from each of its arms alone.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "jamscape/geometry/cluster.hpp"

namespace jam {

/// A shape with name, arms, length and circumradius; the integrals stay zero.
inline ClusterShape arranged(std::string name, std::vector<Arm> arms) {
  ClusterShape shape;
  shape.name = std::move(name);
  for (const Arm& arm : arms) {
    shape.length = std::max(shape.length, 2 * (arm.half_length + arm.radius));
    for (const double end : {-arm.half_length, arm.half_length})
      shape.circumradius = std::max(shape.circumradius, norm(arm.centre + end * arm.direction) + arm.radius);
  }
  shape.arms = std::move(arms);
  return shape;
}

}  // namespace jam
