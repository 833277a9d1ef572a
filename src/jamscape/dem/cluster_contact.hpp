// Where two arms touch: a pure function of their axes, for one contact or several side by side (theory sec. 3).
#pragma once

#include "jamscape/dem/cluster_rules.hpp"
#include "jamscape/geometry/segments.hpp"

namespace jam {

template <class T>
struct ArmTouch {
  Vec<3, T> normal;  ///< unit vector from the first arm to the second
  Vec<3, T> point;   ///< on the line of the closest points, at radius - overlap/2 from the axis of the first
  T overlap;
};

/// Of arms whose closest points lie at s and t. Arms at an angle of sine^2 below `parallel_sine2` count as parallel.
template <ParallelRule rule, class T>
JAM_INLINE ArmTouch<T> touch_arms(const Segment<T>& one, T r1, const Segment<T>& two, T r2, T s, T t,
                                  T parallel_sine2) {
  ArmTouch<T> touch;
  const Vec<3, T> d = t * two.direction - ((one.centre - two.centre) + s * one.direction);
  const T distance = square_root(dot(d, d)), a = dot(one.direction, two.direction), sine2 = T(1.0) - a * a;
  touch.normal = (T(1.0) / distance) * d;
  touch.overlap = (r1 + r2) - distance;
  const auto parallel = sine2 < parallel_sine2;
  if (any(parallel)) {
    T moved = side_by_side(one, two, s);
    if constexpr (rule == ParallelRule::blend) moved = moved + sine2 / parallel_sine2 * (s - moved);
    s = select(parallel, moved, s);
  }
  touch.point = one.centre + s * one.direction + (r1 - T(0.5) * touch.overlap) * touch.normal;
  return touch;
}

}  // namespace jam
