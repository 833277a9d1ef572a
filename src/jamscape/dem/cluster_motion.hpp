// Motion of rigid bodies over one step, written once and compiled for every vector width.
//
// Positions and velocities: leapfrog, as for discs. Rotation: the angular momentum L in the world's frame is kicked by
// the torque, then the body turns freely for dt:
//   one moment of inertia   by w dt about w = L/I, exactly to order (w dt)^9, as the quaternion (1, w tan(|w|
//   dt/2)/|w|) free top                by turns about its own axes x y z y x (half, half, full, half, half), each at
//   the rate
//                           L_e/I_e of that axis; symmetric and symplectic, second order, L kept [Dullweber,
//                           Leimkuhler, McLachlan 1997; Miller et al. 2002]
// The quaternion is normalised in every step.
#pragma once

#include <cmath>

#include "jamscape/dem/cluster_kernel.hpp"

namespace jam {
namespace {  // each file that includes this gets its own copy, compiled for its own vector width

using Four = double __attribute__((vector_size(32)));

inline Four& four(double* p) { return *reinterpret_cast<Four*>(p); }
inline const Four& four(const double* p) { return *reinterpret_cast<const Four*>(p); }

/// The body's axes in the world's frame.
struct Frame {
  Four x, y, z;
};

inline Frame frame_of(const double* q) {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  const double xx = x * x, yy = y * y, zz = z * z, xy = x * y, xz = x * z, yz = y * z, wx = w * x, wy = w * y,
               wz = w * z;
  return {Four{1 - 2 * (yy + zz), 2 * (xy + wz), 2 * (xz - wy), 0},
          Four{2 * (xy - wz), 1 - 2 * (xx + zz), 2 * (yz + wx), 0},
          Four{2 * (xz + wy), 2 * (yz - wx), 1 - 2 * (xx + yy), 0}};
}

inline double along(const Four& axis, const double* v) { return axis[0] * v[0] + axis[1] * v[1] + axis[2] * v[2]; }

/// Multiplies the quaternion by (1, tx, ty, tz) from the left (turn about axes of the world) or right (of the body).
inline void turn_left(double* q, double tx, double ty, double tz) {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  q[0] = w - tx * x - ty * y - tz * z;
  q[1] = x + tx * w + ty * z - tz * y;
  q[2] = y - tx * z + ty * w + tz * x;
  q[3] = z + tx * y - ty * x + tz * w;
}
inline void turn_right(double* q, double tx, double ty, double tz) {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  q[0] = w - x * tx - y * ty - z * tz;
  q[1] = x + w * tx + y * tz - z * ty;
  q[2] = y + w * ty + z * tx - x * tz;
  q[3] = z + w * tz + x * ty - y * tx;
}
inline void normalize(double* q) {
  const double scale = 1 / square_root(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (int c = 0; c < 4; ++c) q[c] *= scale;
}

/// tan(x)/x as a function of x^2.
inline double tangent_factor(double x2) { return 1 + x2 * (1.0 / 3 + x2 * (2.0 / 15 + x2 * (17.0 / 315))); }

/// Turns about axis e of the body for the time dt; l: angular momentum in the body's frame.
inline void turn_about(int e, double* q, double* l, const double* inverse, double dt) {
  const double half = 0.5 * dt * l[e] * inverse[e], t = half * tangent_factor(half * half), t2 = t * t;
  const double scale = 1 / (1 + t2), cosine = (1 - t2) * scale, sine = 2 * t * scale;
  double axis[3] = {0, 0, 0};
  axis[e] = t;
  turn_right(q, axis[0], axis[1], axis[2]);
  const int u = (e + 1) % 3, v = (e + 2) % 3;
  const double lu = l[u], lv = l[v];
  l[u] = cosine * lu + sine * lv;
  l[v] = cosine * lv - sine * lu;
}

inline void turn_top(double* q, const double* momentum, const double* inverse, double dt) {
  const Frame f = frame_of(q);
  double l[3] = {along(f.x, momentum), along(f.y, momentum), along(f.z, momentum)};
  turn_about(0, q, l, inverse, dt / 2);
  turn_about(1, q, l, inverse, dt / 2);
  turn_about(2, q, l, inverse, dt);
  turn_about(1, q, l, inverse, dt / 2);
  turn_about(0, q, l, inverse, dt / 2);
  normalize(q);
}

inline void turn_even(double* q, const double* spin, double spin2, double dt) {
  const double half = 0.5 * dt, factor = half * tangent_factor(half * half * spin2);
  turn_left(q, factor * spin[0], factor * spin[1], factor * spin[2]);
  normalize(q);
}

/// Spin in the world's frame.
inline Four top_spin(const Frame& f, const double* momentum, const double* inverse) {
  return (along(f.x, momentum) * inverse[0]) * f.x + (along(f.y, momentum) * inverse[1]) * f.y +
         (along(f.z, momentum) * inverse[2]) * f.z;
}

/// Arms of a body at `row` from its own frame to the world's. The fourth numbers, r and h, come along.
inline void place_arms(const double* row, const Frame& f, const double* own, double* arms, std::size_t count) {
  const Four x{row[0], row[1], row[2], 0};
  for (std::size_t a = 0; a < count; ++a, own += ClusterRow::arm_stride, arms += ClusterRow::arm_stride) {
    four(arms) = x + own[0] * f.x + own[1] * f.y + own[2] * f.z + Four{0, 0, 0, own[3]};
    four(arms + 4) = own[4] * f.x + own[5] * f.y + own[6] * f.z + Four{0, 0, 0, own[7]};
  }
}

inline void integrate(MotionArrays& b) {
  using R = ClusterRow;
  const double dt = b.dt;
  double fastest = 0;
  for (std::size_t k = 0; k < b.count; ++k) {
    double* row = b.rows + k * R::stride;
    double* force = b.forces + k * R::force_stride;
    double* momentum = b.momentum + 4 * k;
    const double* inverse = b.inverse + k * R::force_stride;
    four(row + R::velocity) += four(force) * four(inverse) * dt;
    four(row) += four(row + R::velocity) * dt;
    four(momentum) += four(force + 4) * dt;
    four(force) = four(force + 4) = Four{0, 0, 0, 0};

    double* q = row + R::orientation;
    double* spin = row + R::spin;
    const double reach = row[R::reach];
    double spin2;
    Frame f;
    if (b.top[k]) {
      turn_top(q, momentum, inverse + 4, dt);
      f = frame_of(q);
      four(spin) = top_spin(f, momentum, inverse + 4);
      const double most = larger(inverse[4], larger(inverse[5], inverse[6]));
      spin2 = (momentum[0] * momentum[0] + momentum[1] * momentum[1] + momentum[2] * momentum[2]) * (most * most);
    } else {
      four(spin) = four(momentum) * four(inverse + 4);
      spin2 = spin[0] * spin[0] + spin[1] * spin[1] + spin[2] * spin[2];
      turn_even(q, spin, spin2, dt);
      f = frame_of(q);
    }
    spin[3] = reach;
    const double* v = row + R::velocity;
    fastest = larger(fastest, square_root(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) + square_root(spin2) * reach);
    const std::size_t from = b.first_arm[k], count = b.first_arm[k + 1] - from;
    place_arms(row, f, b.own_arms + from * R::arm_stride, b.arms + from * R::arm_stride, count);
  }
  b.farthest = fastest * dt;
}

}  // namespace
}  // namespace jam
