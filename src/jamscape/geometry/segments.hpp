// Closest points of two segments, for one pair (T = double) or several side by side (SIMD lanes).
//
//   P = c1 + s u1, |s| <= h1;   Q = c2 + t u2, |t| <= h2;   w = c1 - c2,  a = u1.u2
//   s = clamp((a w.u2 - w.u1) / (1 - a^2)),  t = clamp(a s + w.u2),  s = clamp(a t - w.u1)
//
// The last step changes s where t was clamped and gives the same s where it was not. A segment of h = 0 is a point.
// Parallel segments: every s of the stretch they share is a minimum, and one of them comes out; the distance is right.
// Source: lumelsky1985; theory sec. 3.
#pragma once

#include "jamscape/geometry/cluster.hpp"
#include "jamscape/geometry/vec.hpp"

namespace jam {

template <class T>
struct Segment {
  Vec<3, T> centre, direction;  ///< direction: a unit vector
  T half_length;
};

template <class T>
struct ClosestPoints {
  T s, t;       ///< along the first and the second segment, from their centres
  Vec<3, T> d;  ///< from P to Q
  T distance2;  ///< d.d
};

template <class T>
JAM_INLINE T clamp_to(T a, T limit) {
  return smaller(larger(a, -limit), limit);
}

template <class T>
JAM_INLINE ClosestPoints<T> closest_points(const Segment<T>& one, const Segment<T>& two) {
  // Below this angle (1e-6 rad) squared, 1 - a^2 is made of rounding errors, and the distance varies by less than
  // 1e-12 h^2 / distance along the segments.
  constexpr double parallel = 1e-12;
  const Vec<3, T> w = one.centre - two.centre;
  const T a = dot(one.direction, two.direction), w1 = dot(w, one.direction), w2 = dot(w, two.direction);
  ClosestPoints<T> c;
  const T skew = clamp_to((a * w2 - w1) / larger(T(1.0) - a * a, T(parallel)), one.half_length);
  c.t = clamp_to(a * skew + w2, two.half_length);
  c.s = clamp_to(a * c.t - w1, one.half_length);
  c.d = c.t * two.direction - (w + c.s * one.direction);
  c.distance2 = dot(c.d, c.d);
  return c;
}

/// Where on the first of two parallel segments lies the middle of the stretch along which they lie side by side; `s`
/// where there is none.
template <class T>
JAM_INLINE T side_by_side(const Segment<T>& one, const Segment<T>& two, T s) {
  const Vec<3, T> w = one.centre - two.centre;
  const T middle = -dot(w, one.direction), half = two.half_length * magnitude(dot(one.direction, two.direction));
  const T lo = larger(-one.half_length, middle - half), hi = smaller(one.half_length, middle + half);
  return select(lo > hi, s, T(0.5) * (lo + hi));
}

/// Distance of the axes of two arms.
double axis_distance(const Arm& one, const Arm& two);

}  // namespace jam
