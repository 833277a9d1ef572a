// Where two arms touch: a pure function of their axes, for one contact or several side by side (theory sec. 3).
#pragma once

#include "jamscape/dem/cluster_bodies.hpp"
#include "jamscape/dem/cluster_rules.hpp"
#include "jamscape/geometry/segments.hpp"

namespace jam {

/// The closest points of two arms.
template <class T>
struct ArmApproach {
  Vec<3, T> d;     ///< from the axis of the first to that of the second
  T distance2;     ///< d.d
  Vec<3, T> foot;  ///< on the axis of the first, where they touch if they do
  T r1, r2;

  JAM_INLINE auto touching() const {
    const T reach = r1 + r2;
    return distance2 < reach * reach;
  }
};

template <class T>
struct ArmTouch {
  Vec<3, T> normal;  ///< unit vector from the first arm to the second
  Vec<3, T> point;   ///< on the line of the closest points, at radius - overlap/2 from the axis of the first
  T overlap;
};

// In two steps, for the loops that take them apart; results are built in place, wide ones are large.

/// The closest points; arms at an angle of sine^2 below `parallel_sine2` count as parallel and touch where `rule` says.
template <ParallelRule rule, class T>
JAM_INLINE void approach(const Segment<T>& one, T r1, const Segment<T>& two, T r2, T parallel_sine2,
                         ArmApproach<T>& to) {
  const ClosestPoints<T> c = closest_points(one, two);
  const T a = dot(one.direction, two.direction), sine2 = T(1.0) - a * a;
  T s = c.s;
  const auto parallel = sine2 < parallel_sine2;
  if (any(parallel)) {
    T moved = side_by_side(one, two, s);
    if constexpr (rule == ParallelRule::blend) moved = moved + sine2 / parallel_sine2 * (s - moved);
    s = select(parallel, moved, s);
  }
  to.d = c.d, to.distance2 = c.distance2, to.foot = one.centre + s * one.direction;
  to.r1 = r1, to.r2 = r2;
}

/// What follows from them.
template <class T>
JAM_INLINE void touch_of(const ArmApproach<T>& arms, ArmTouch<T>& touch) {
  const T distance = square_root(arms.distance2);
  touch.normal = (T(1.0) / distance) * arms.d;
  touch.overlap = (arms.r1 + arms.r2) - distance;
  touch.point = arms.foot + (arms.r1 - T(0.5) * touch.overlap) * touch.normal;
}

/// Of two arm rows.
template <ParallelRule rule>
ArmTouch<double> touch_arms(const double* one, const double* two, double parallel_sine2) {
  ArmApproach<double> arms;
  approach<rule>(axis_of(one), one[3], axis_of(two), two[3], parallel_sine2, arms);
  ArmTouch<double> touch;
  touch_of(arms, touch);
  return touch;
}
inline ArmTouch<double> touch_arms(ParallelRule rule, const double* one, const double* two, double parallel_sine2) {
  return rule == ParallelRule::middle ? touch_arms<ParallelRule::middle>(one, two, parallel_sine2)
                                      : touch_arms<ParallelRule::blend>(one, two, parallel_sine2);
}

}  // namespace jam
