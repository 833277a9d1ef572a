// Motion of rigid bodies over one step, written once and compiled for every vector width.
//
// Positions and velocities: leapfrog, as for discs. Rotation: the angular momentum L in the world's frame is kicked by
// the torque, then the body turns freely for dt:
//
//   one moment of inertia   about w = L/I, as the quaternion (1, w tan(|w| dt/2)/|w|), good to order (w dt)^9
//   free top                about its own axes x y z y x in turn, for dt (1/2, 1/2, 1, 1/2, 1/2), each at the rate
//                           L_e/I_e of that axis: symmetric, symplectic, second order, L kept [dullweber1997]
//
// The quaternion is normalised in every step.
#pragma once

#include "jamscape/dem/cluster_kernel.hpp"

namespace jam {
namespace {  // each file that includes this gets its own copy, compiled for its own vector width

using Four = double __attribute__((vector_size(32)));

inline Four& four(double* p) { return *reinterpret_cast<Four*>(p); }
inline const Four& four(const double* p) { return *reinterpret_cast<const Four*>(p); }

/// A quaternion of numbers, or of lanes.
template <class T>
struct Turn {
  T w, x, y, z;
};

/// The body's axes in the world's frame.
template <class T>
struct Frame {
  Vec<3, T> x, y, z;
};

template <class T>
JAM_INLINE Frame<T> frame_of(const Turn<T>& q) {
  const T one(1.0), two(2.0);
  const T xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z, xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z,
          wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  return {{one - two * (yy + zz), two * (xy + wz), two * (xz - wy)},
          {two * (xy - wz), one - two * (xx + zz), two * (yz + wx)},
          {two * (xz + wy), two * (yz - wx), one - two * (xx + yy)}};
}
JAM_INLINE Turn<double> turn_at(const double* q) { return {q[0], q[1], q[2], q[3]}; }

/// q times (1, t) from the left (a turn about axes of the world) or the right (of the body).
template <class T>
JAM_INLINE Turn<T> turn_left(const Turn<T>& q, const Vec<3, T>& t) {
  return {q.w - t[0] * q.x - t[1] * q.y - t[2] * q.z, q.x + t[0] * q.w + t[1] * q.z - t[2] * q.y,
          q.y - t[0] * q.z + t[1] * q.w + t[2] * q.x, q.z + t[0] * q.y - t[1] * q.x + t[2] * q.w};
}
inline Turn<double> turn_right(const Turn<double>& q, const Vec3& t) {
  return {q.w - q.x * t[0] - q.y * t[1] - q.z * t[2], q.x + q.w * t[0] + q.y * t[2] - q.z * t[1],
          q.y + q.w * t[1] + q.z * t[0] - q.x * t[2], q.z + q.w * t[2] + q.x * t[1] - q.y * t[0]};
}
template <class T>
JAM_INLINE Turn<T> unit(const Turn<T>& q) {
  const T scale = T(1.0) / square_root(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w * scale, q.x * scale, q.y * scale, q.z * scale};
}

/// tan(x)/x as a function of x^2.
template <class T>
JAM_INLINE T tangent_factor(T x2) {
  return T(1.0) + x2 * (T(1.0 / 3) + x2 * (T(2.0 / 15) + x2 * T(17.0 / 315)));
}

/// Orientation after the time dt at this spin.
template <class T>
JAM_INLINE Turn<T> turn_even(const Turn<T>& q, const Vec<3, T>& spin, T spin2, T dt) {
  const T half = T(0.5) * dt, factor = half * tangent_factor(half * half * spin2);
  return unit(turn_left(q, factor * spin));
}

/// What no point of a body moves farther than, in a unit of time.
template <class T>
JAM_INLINE T fastest_point(const Vec<3, T>& velocity, T spin2, T reach) {
  return square_root(dot(velocity, velocity)) + square_root(spin2) * reach;
}

inline Vec3 to_body(const Frame<double>& f, const double* v) {
  const Vec3 a{v[0], v[1], v[2]};
  return {dot(f.x, a), dot(f.y, a), dot(f.z, a)};
}

/// Turns about axis e of the body for the time dt; l: angular momentum in the body's frame.
inline void turn_about(int e, Turn<double>& q, Vec3& l, const double* inverse, double dt) {
  const double half = 0.5 * dt * l[e] * inverse[e], t = half * tangent_factor(half * half), t2 = t * t;
  const double scale = 1 / (1 + t2), cosine = (1 - t2) * scale, sine = 2 * t * scale;
  Vec3 axis{0, 0, 0};
  axis[e] = t;
  q = turn_right(q, axis);
  const int u = (e + 1) % 3, v = (e + 2) % 3;
  const double lu = l[u], lv = l[v];
  l[u] = cosine * lu + sine * lv;
  l[v] = cosine * lv - sine * lu;
}

inline Turn<double> turn_top(Turn<double> q, const double* momentum, const double* inverse, double dt) {
  Vec3 l = to_body(frame_of(q), momentum);
  turn_about(0, q, l, inverse, dt / 2);
  turn_about(1, q, l, inverse, dt / 2);
  turn_about(2, q, l, inverse, dt);
  turn_about(1, q, l, inverse, dt / 2);
  turn_about(0, q, l, inverse, dt / 2);
  return unit(q);
}

/// Spin in the world's frame.
inline Vec3 top_spin(const Frame<double>& f, const double* momentum, const double* inverse) {
  const Vec3 l = to_body(f, momentum);
  return (l[0] * inverse[0]) * f.x + (l[1] * inverse[1]) * f.y + (l[2] * inverse[2]) * f.z;
}

/// Frame of a body in rows of four, the fourth 0.
struct FrameRows {
  Four x, y, z;
};
inline FrameRows rows_of(const Frame<double>& f) {
  return {Four{f.x[0], f.x[1], f.x[2], 0}, Four{f.y[0], f.y[1], f.y[2], 0}, Four{f.z[0], f.z[1], f.z[2], 0}};
}

/// Puts the arms of a body at `row` where they are in the world: those of its shape, `own`, times `scale`. The fourth
/// numbers, r and h, come along. `centred`: the arms' centres are the body's.
template <bool centred>
JAM_INLINE void place_arms(const double* row, const FrameRows& f, const double* own, double scale, double* arms,
                           std::size_t count) {
  const auto with_fourth = [](Four a, Four b) { return __builtin_shufflevector(a, b, 0, 1, 2, 7); };
  const Four x = four(row);
  for (std::size_t a = 0; a < count; ++a, own += ClusterRow::arm_stride, arms += ClusterRow::arm_stride) {
    const Four c = scale * four(own), h = scale * four(own + 4);
    if constexpr (centred)
      four(arms) = with_fourth(x, c);
    else
      four(arms) = with_fourth(x + c[0] * f.x + c[1] * f.y + c[2] * f.z, c);
    four(arms + 4) = with_fourth(own[4] * f.x + own[5] * f.y + own[6] * f.z, h);
  }
}
inline void place_arms(MotionArrays& b, std::size_t k, const FrameRows& f) {
  const std::size_t from = b.first_arm[k], count = b.first_arm[k + 1] - from;
  const double *row = b.rows + k * ClusterRow::stride, *own = b.own_arms + b.first_own[k];
  double* arms = b.arms + from * ClusterRow::arm_stride;
  b.centred ? place_arms<true>(row, f, own, b.scale[k], arms, count)
            : place_arms<false>(row, f, own, b.scale[k], arms, count);
}

/// Velocity, position and angular momentum, the step's forces used up.
JAM_INLINE void kick_and_drift(MotionArrays& b, std::size_t k) {
  using R = ClusterRow;
  double *row = b.rows + k * R::stride, *force = b.forces + k * R::force_stride;
  const Four weight = row[R::mass] * four(b.gravity);
  four(row + R::velocity) += (four(force) + weight) * four(b.inverse + k * R::force_stride) * b.dt;
  four(row) += four(row + R::velocity) * b.dt;
  four(b.momentum + 4 * k) += four(force + 4) * b.dt;
  four(force) = four(force + 4) = Four{0, 0, 0, 0};
}

inline void integrate_body(MotionArrays& b, std::size_t k) {
  using R = ClusterRow;
  kick_and_drift(b, k);
  double *row = b.rows + k * R::stride, *momentum = b.momentum + 4 * k;
  const double* inverse = b.inverse + k * R::force_stride + 4;
  Turn<double> q = turn_at(row + R::orientation);
  Vec3 spin;
  double spin2;
  Frame<double> f;
  if (b.top[k]) {
    q = turn_top(q, momentum, inverse, b.dt);
    f = frame_of(q);
    spin = top_spin(f, momentum, inverse);
    const double most = larger(inverse[0], larger(inverse[1], inverse[2]));
    spin2 = (momentum[0] * momentum[0] + momentum[1] * momentum[1] + momentum[2] * momentum[2]) * (most * most);
  } else {
    spin = {momentum[0] * inverse[0], momentum[1] * inverse[1], momentum[2] * inverse[2]};
    spin2 = dot(spin, spin);
    q = turn_even(q, spin, spin2, b.dt);
    f = frame_of(q);
  }
  for (int c = 0; c < 3; ++c) row[R::spin + static_cast<std::size_t>(c)] = spin[c];
  four(row + R::orientation) = Four{q.w, q.x, q.y, q.z};
  place_arms(b, k, rows_of(f));
  const double* v = row + R::velocity;
  b.moved[k] += fastest_point(Vec3{v[0], v[1], v[2]}, spin2, row[R::reach]) * b.dt;
  b.outrun = b.outrun || !(b.moved[k] < b.skin[k]);
}

inline void integrate(MotionArrays& b) {
  for (std::size_t k = 0; k < b.count; ++k) integrate_body(b, k);
}

}  // namespace
}  // namespace jam
