#include <algorithm>
#include <cmath>

#include "jamscape/dem/cluster_engine.hpp"

namespace jam {

double ClusterEngine::highest(int axis) const {
  double top = 0;
  for (std::size_t a = 0; a < bodies_.arm_count(); ++a) {
    const Segment<double> arm = axis_of(bodies_.arm(a));
    const double end = arm.centre[axis] + arm.half_length * std::abs(arm.direction[axis]) + bodies_.arm(a)[3];
    top = a == 0 ? end : std::max(top, end);
  }
  return top;
}

}  // namespace jam
