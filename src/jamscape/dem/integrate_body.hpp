// The integration passes, written once and compiled for every vector width. Bodies with inverse inertia 0 (wall beads)
// keep their velocity.
//
// Verlet in leapfrog form: the row holds v(n-1/2); v += a dt; x += v dt. That is velocity Verlet whose forces see the
// velocity of the half step (theory sec. 2.5).
//
// Gear, five values, velocity-dependent forces (S1 App. A; coefficients of theory sec. 2.5): the row holds the
// predicted x and v the forces were computed at; correct with da = a(forces) - a(predicted), then predict the next
// step. In plain derivatives instead of the scaled ones r_k = dt^k/k! x^(k):
//   x += c0 dt^2/2 da,  v += c1 dt/2 da,  a += da,  jerk += 3 c3/dt da,  snap += 12 c4/dt^2 da.
#pragma once

#include <cstddef>

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

template <int D>
void verlet(BodyArrays& b) {
  using R = Row<D>;
  const Piece dt = all(b.dt), zero = all(0);
  Piece fastest = zero;
  for (std::size_t k = 0; k < b.count; ++k) {
    double* row = b.rows + k * R::stride;
    double* force = b.forces + k * R::force_stride;
    const double* inverse = b.inverse + k * R::force_stride;
    for (int m = 0; m < R::motions; ++m) {
      Piece& v = piece(row + R::velocity_of(m));
      Piece& x = piece(row + R::position_of(m));
      v += piece(force + 4 * m) * piece(inverse + 4 * m) * dt;
      x += v * dt;
      piece(force + 4 * m) = zero;
      if (m == 0) keep_larger(fastest, v);
    }
  }
  for (int c = 0; c < 4; ++c) b.fastest[c] = fastest[c];
}

template <int D>
void gear(BodyArrays& b) {
  using R = Row<D>;
  constexpr double c0 = 19.0 / 90, c1 = 3.0 / 4, c3 = 1.0 / 2, c4 = 1.0 / 12;
  const double h = b.dt;
  const Piece k0 = all(c0 * h * h / 2), k1 = all(c1 * h / 2), k3 = all(3 * c3 / h), k4 = all(12 * c4 / (h * h));
  const Piece t1 = all(h), t2 = all(h * h / 2), t3 = all(h * h * h / 6), t4 = all(h * h * h * h / 24), zero = all(0);
  Piece fastest = zero;
  for (std::size_t k = 0; k < b.count; ++k) {
    double* row = b.rows + k * R::stride;
    double* force = b.forces + k * R::force_stride;
    const double* inverse = b.inverse + k * R::force_stride;
    double* derivative = b.derivatives + k * 12 * R::motions;
    for (int m = 0; m < R::motions; ++m, derivative += 12) {
      Piece x = piece(row + R::position_of(m)), v = piece(row + R::velocity_of(m));
      Piece a = piece(derivative), jerk = piece(derivative + 4), snap = piece(derivative + 8);
      const Piece now = piece(force + 4 * m) * piece(inverse + 4 * m), da = now - a;
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
  }
  for (int c = 0; c < 4; ++c) b.fastest[c] = fastest[c];
}

}  // namespace
}  // namespace jam
