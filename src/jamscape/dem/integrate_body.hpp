// The integration passes, written once and compiled for every vector width. Bodies with inverse inertia 0 (wall beads)
// keep their velocity. The last body comes first: the pair loop has just left it in the cache, and will begin with the
// first one.
//
// Verlet in leapfrog form: the row holds v(n-1/2); v += a dt; x += v dt. That is velocity Verlet whose forces see the
// velocity of the half step (theory sec. 2.5).
//
// Gear, five values, velocity-dependent forces (S1 App. A; coefficients of theory sec. 2.5): the row holds the
// predicted x and v the forces were computed at; correct with da = a(forces) - a(predicted), then predict the next
// step. In plain derivatives instead of the scaled ones r_k = dt^k/k! x^(k):
//   x += c0 dt^2/2 da,  v += c1 dt/2 da,  a += da,  jerk += 3 c3/dt da,  snap += 12 c4/dt^2 da.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "jamscape/dem/kernel.hpp"

namespace jam {
namespace {  // each file that includes this gets its own copy, compiled for its own vector width

using Piece = double __attribute__((vector_size(32)));

inline Piece& piece(double* p) { return *reinterpret_cast<Piece*>(p); }
inline const Piece& piece(const double* p) { return *reinterpret_cast<const Piece*>(p); }
inline Piece all(double a) { return Piece{a, a, a, a}; }

inline void keep_larger(Piece& largest, const Piece& v) {
  const Piece square = v * v;
  largest = largest > square ? largest : square;
}

/// Inverse inertias for the components of motion m of body k.
template <int D>
Piece inverse_of(const BodyArrays& b, std::size_t k, int m) {
  const double* q = b.inverse + 2 * k;
  return D == 2 ? Piece{q[0], q[0], q[1], q[1]} : all(q[m]);
}

/// Whether nothing has pushed: all bits are those of +0, as the pass before left them.
template <int D>
bool untouched(const double* force) {
  using Bits [[gnu::may_alias]] = std::uint64_t;
  const Bits* b = reinterpret_cast<const Bits*>(force);
  std::uint64_t some = b[0] | b[1] | b[2];  // the fourth is 0 in any case
  if constexpr (D == 3) some |= b[4] | b[5] | b[6];
  return some == 0;
}

template <int D, bool skip>
void verlet_loop(BodyArrays& b) {
  using R = Row<D>;
  const Piece dt = all(b.dt), zero = all(0);
  Piece fastest = zero;
  for (std::size_t k = b.count; k-- > 0;) {
    double* row = b.rows + k * R::stride;
    double* force = b.forces + k * R::force_stride;
    const bool still = skip && untouched<D>(force);
    for (int m = 0; m < R::motions; ++m) {
      Piece v = piece(row + R::velocity_of(m));
      if (still) {
        v += zero;  // as a force of zero would: -0 becomes +0
      } else {
        v += piece(force + 4 * m) * inverse_of<D>(b, k, m) * dt;
        piece(force + 4 * m) = zero;
      }
      if (m == 0) keep_larger(fastest, v);
      piece(row + R::velocity_of(m)) = v;
      piece(row + R::position_of(m)) += v * dt;
    }
  }
  for (int c = 0; c < 4; ++c) b.fastest[c] = fastest[c];
}

template <int D>
void verlet(BodyArrays& b) {
  b.few_pushed ? verlet_loop<D, true>(b) : verlet_loop<D, false>(b);
}

/// Sets the derivatives of a body in free flight to +0 once all are below 2^-767, where they change no position or
/// velocity; true if so. They decay that far in some thirty steps, and no farther: one flushed to zero keeps the others.
template <int D>
bool calm_down(double* derivative) {
  using Bits [[gnu::may_alias]] = std::uint64_t;
  constexpr std::uint64_t upper_exponent = 0x7000000000000000;
  constexpr int count = 12 * Row<D>::motions;
  const Bits* b = reinterpret_cast<const Bits*>(derivative);
  std::uint64_t some = 0;
  for (int c = 0; c < count; ++c) some |= b[c];
  if (some & upper_exponent) return false;
  std::fill_n(derivative, count, 0.0);
  return true;
}

template <int D, bool skip>
void gear_loop(BodyArrays& b) {
  using R = Row<D>;
  constexpr double c0 = 19.0 / 90, c1 = 3.0 / 4, c3 = 1.0 / 2, c4 = 1.0 / 12;
  const double h = b.dt;
  const Piece k0 = all(c0 * h * h / 2), k1 = all(c1 * h / 2), k3 = all(3 * c3 / h), k4 = all(12 * c4 / (h * h));
  const Piece t1 = all(h), t2 = all(h * h / 2), t3 = all(h * h * h / 6), t4 = all(h * h * h * h / 24), zero = all(0);
  Piece fastest = zero;
  for (std::size_t k = b.count; k-- > 0;) {
    double* row = b.rows + k * R::stride;
    double* force = b.forces + k * R::force_stride;
    double* derivative = b.derivatives + k * 12 * R::motions;
    const bool free = skip && untouched<D>(force);
    if (free && b.calm[k]) {  // what follows, with zeros for force and derivatives
      for (int m = 0; m < R::motions; ++m) {
        Piece v = piece(row + R::velocity_of(m)), x = piece(row + R::position_of(m));
        v += zero, x += zero;  // -0 becomes +0
        if (m == 0) keep_larger(fastest, v);
        piece(row + R::velocity_of(m)) = v;
        piece(row + R::position_of(m)) = x + t1 * v;
      }
      continue;
    }
    for (int m = 0; m < R::motions; ++m, derivative += 12) {
      Piece x = piece(row + R::position_of(m)), v = piece(row + R::velocity_of(m));
      Piece a = piece(derivative), jerk = piece(derivative + 4), snap = piece(derivative + 8);
      const Piece now = piece(force + 4 * m) * inverse_of<D>(b, k, m), da = now - a;
      x += k0 * da;
      v += k1 * da;
      jerk += k3 * da;
      snap += k4 * da;
      if (m == 0) keep_larger(fastest, v);
      piece(row + R::position_of(m)) = x + t1 * v + t2 * now + t3 * jerk + t4 * snap;
      v = v + t1 * now + t2 * jerk + t3 * snap;
      if (m == 0) keep_larger(fastest, v);
      piece(row + R::velocity_of(m)) = v;
      piece(derivative) = now + t1 * jerk + t2 * snap;
      piece(derivative + 4) = jerk + t1 * snap;
      piece(derivative + 8) = snap;
      piece(force + 4 * m) = zero;
    }
    if constexpr (skip) b.calm[k] = free && calm_down<D>(derivative - 12 * R::motions);
  }
  for (int c = 0; c < 4; ++c) b.fastest[c] = fastest[c];
}

template <int D>
void gear(BodyArrays& b) {
  if (b.few_pushed) return gear_loop<D, true>(b);
  std::memset(b.calm, 0, b.count);
  gear_loop<D, false>(b);
}

}  // namespace
}  // namespace jam
