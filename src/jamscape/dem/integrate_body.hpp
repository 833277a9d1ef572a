// The integration passes, written once and compiled for every vector width. Bodies with inverse inertia 0 (wall beads)
// keep their velocity. The last body comes first: the pair loop has just left it in the cache, and will begin with the
// first one. Two motions go at a time; where few bodies are pushed, the two are left to drift if nothing pushes either.
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
#include "jamscape/dem/motions.hpp"

namespace jam {
namespace {  // each file that includes this gets its own copy, compiled for its own vector width

using Bits [[gnu::may_alias]] = std::uint64_t;

/// Whether nothing has pushed a body: all bits are those of +0, as the pass before left them.
template <int D>
JAM_INLINE bool untouched(const double* force) {
  const Bits* b = reinterpret_cast<const Bits*>(force);
  std::uint64_t some = b[0] | b[1] | b[2];  // the fourth is 0 in any case
  if constexpr (D == 3) some |= b[4] | b[5] | b[6];
  return some == 0;
}

template <int D>
struct VerletPass {
  BodyArrays& b;

  template <class Unit>
  JAM_INLINE void move(std::size_t k, typename Unit::Vector& fastest) const {
    using V = typename Unit::Vector;
    double* row = b.rows + k * Row<D>::stride;
    double* forces = b.forces + k * Row<D>::force_stride;
    for (int m = 0; m < Unit::vectors; ++m) {
      V x, v, inverse;
      Unit::load_motion(row, m, x, v);
      Unit::load_inverse(b.inverse + 2 * k, m, inverse);
      v += Unit::force(forces, m) * inverse * b.dt;
      Unit::force(forces, m) = V{};
      Unit::keep_fastest(fastest, m, v);
      Unit::store_motion(row, m, x + v * b.dt, v);
    }
  }
  /// What move() does where the force is zero. -0 becomes +0.
  template <class V>
  JAM_INLINE void drift(V& x, V& v) const {
    v += V{};
    x += v * b.dt;
  }

  void forget() const {}
  bool may_drift(std::size_t) const { return true; }
  void has_moved(std::size_t, bool) const {}
};

template <int D>
struct GearPass {
  static constexpr double c0 = 19.0 / 90, c1 = 3.0 / 4, c3 = 1.0 / 2, c4 = 1.0 / 12;
  static constexpr std::size_t derivatives = 12 * static_cast<std::size_t>(Row<D>::motions);
  BodyArrays& b;
  const double h = b.dt;
  const double k0 = c0 * h * h / 2, k1 = c1 * h / 2, k3 = 3 * c3 / h, k4 = 12 * c4 / (h * h);
  const double t1 = h, t2 = h * h / 2, t3 = h * h * h / 6, t4 = h * h * h * h / 24;

  template <class Unit>
  JAM_INLINE void move(std::size_t k, typename Unit::Vector& fastest) const {
    using V = typename Unit::Vector;
    double* row = b.rows + k * Row<D>::stride;
    double* forces = b.forces + k * Row<D>::force_stride;
    double* higher = b.derivatives + k * derivatives;
    fetch<Unit::bodies>(k);
    for (int m = 0; m < Unit::vectors; ++m) {
      V x, v, a, jerk, snap, inverse;
      Unit::load_motion(row, m, x, v);
      Unit::load_derivatives(higher, m, a, jerk, snap);
      Unit::load_inverse(b.inverse + 2 * k, m, inverse);
      const V now = Unit::force(forces, m) * inverse, da = now - a;
      Unit::force(forces, m) = V{};
      x += k0 * da;
      v += k1 * da;
      jerk += k3 * da;
      snap += k4 * da;
      Unit::keep_fastest(fastest, m, v);
      x = x + t1 * v + t2 * now + t3 * jerk + t4 * snap;
      v = v + t1 * now + t2 * jerk + t3 * snap;
      Unit::keep_fastest(fastest, m, v);
      Unit::store_motion(row, m, x, v);
      Unit::store_derivatives(higher, m, now + t1 * jerk + t2 * snap, jerk + t1 * snap, snap);
    }
  }
  /// Calls the derivatives of the bodies some turns from now into the cache: nothing else does, and the processor by
  /// itself stops at the end of each page.
  template <std::size_t bodies>
  JAM_INLINE void fetch(std::size_t k) const {
    constexpr std::size_t ahead = 24, line = 8;
    const double* from = b.derivatives + (k < ahead ? k : k - ahead) * derivatives;
    for (std::size_t c = 0; c < bodies * derivatives; c += line) __builtin_prefetch(from + c, 1);
  }
  /// What move() does where force and derivatives are zero. -0 becomes +0.
  template <class V>
  JAM_INLINE void drift(V& x, V& v) const {
    x += V{}, v += V{};
    x += t1 * v;
  }

  void forget() const { std::memset(b.calm, 0, b.count); }
  bool may_drift(std::size_t k) const { return b.calm[k]; }
  /// Sets the derivatives of a body in free flight to +0 once all are below 2^-767, where they change no position or
  /// velocity. They decay that far in some thirty steps, and no farther: one flushed to zero keeps the others.
  void has_moved(std::size_t k, bool free) const {
    if (free == static_cast<bool>(b.calm[k])) return;
    if (!free) {
      b.calm[k] = 0;
      return;
    }
    constexpr std::uint64_t upper_exponent = 0x7000000000000000;
    double* higher = b.derivatives + k * derivatives;
    const Bits* bits = reinterpret_cast<const Bits*>(higher);
    std::uint64_t some = 0;
    for (std::size_t c = 0; c < derivatives; ++c) some |= bits[c];
    if (some & upper_exponent) return;
    std::fill_n(higher, derivatives, 0.0);
    b.calm[k] = 1;
  }
};

/// The bodies of a unit, from k on. `few`: they are left to drift where nothing else moves them.
template <int D, class Unit, bool few, class Pass>
JAM_INLINE void visit(BodyArrays& b, const Pass& pass, std::size_t k, typename Unit::Vector& fastest) {
  constexpr std::size_t force_stride = Row<D>::force_stride;
  if constexpr (!few) {
    pass.template move<Unit>(k, fastest);
  } else {
    bool free[Unit::bodies], drift = true;
    for (std::size_t n = 0; n < Unit::bodies; ++n) {
      free[n] = untouched<D>(b.forces + (k + n) * force_stride);
      drift = drift & free[n] & pass.may_drift(k + n);
    }
    if (drift) {
      double* row = b.rows + k * Row<D>::stride;
      for (int m = 0; m < Unit::vectors; ++m) {
        typename Unit::Vector x, v;
        Unit::load_motion(row, m, x, v);
        pass.drift(x, v);
        Unit::keep_fastest(fastest, m, v);
        Unit::store_motion(row, m, x, v);
      }
    } else {
      pass.template move<Unit>(k, fastest);
      for (std::size_t n = 0; n < Unit::bodies; ++n) pass.has_moved(k + n, free[n]);
    }
  }
}

template <int D, bool few, class Pass>
void move(BodyArrays& b, const Pass& pass) {
  using Unit = TwoMotions<D>;
  Piece one{};
  Two both{};
  std::size_t k = b.count;
  for (; k % Unit::bodies; --k) visit<D, OneBody<D>, few>(b, pass, k - 1, one);
  for (; k > 0; k -= Unit::bodies) visit<D, Unit, few>(b, pass, k - Unit::bodies, both);
  for (int c = 0; c < 4; ++c) {
    b.fastest[c] = larger(one[c], both[c]);
    if (D == 2) b.fastest[c] = larger(b.fastest[c], both[c + 4]);  // of spheres that is the spin
  }
}

template <int D, class Pass>
void integrate(BodyArrays& b, const Pass& pass) {
  if (b.few_pushed) return move<D, true>(b, pass);
  pass.forget();
  move<D, false>(b, pass);
}

template <int D>
void verlet(BodyArrays& b) {
  integrate<D>(b, VerletPass<D>{b});
}

template <int D>
void gear(BodyArrays& b) {
  integrate<D>(b, GearPass<D>{b});
}

}  // namespace
}  // namespace jam
