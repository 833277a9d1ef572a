// The force of one contact as a pure function of a few numbers (scalars T: double, or SIMD lanes of doubles).
//
//   n            unit normal from i to j;  x > 0 overlap;  v = v_i - v_j;  v_n = -(v.n) speed of separation
//   normal       F_n = s(x) (k_n x - gamma_n mbar v_n),   s = 1 (linear) or sqrt(x) (Hertz)     [S1 App. A; S2 Eq. 1]
//   tangential   v_t = v - n (v.n) + (l_i w_i + l_j w_j) x n,   xi += v_t dt,   xi -= n (n.xi)
//                F* = -s(x) (k_t xi + gamma_t mbar v_t),   cut at |F*| = mu |F_n|, xi then reset to give that force;
//                s(x) stands in all of these, so the limit is applied before it: no division by s, none without sliding
//   tsuji        is hertz with mbar / x^(1/4) in the dashpots
//   ratio        is linear with mbar^(1/2) in the dashpots, and cut at |F*| = mu k_n x                    [S3 Eq. 3, 5]
//   forces       on i: -F_n n + f_t,  on j the opposite;   torque on i: l_i n x f_t,  on j: l_j n x f_t
//
// l is the lever arm R (or R - x/2). In two dimensions spins, springs and tangential forces are scalars: spins about z,
// springs and forces along t = (-n_y, n_x); turning with the contact replaces the projection of xi, which it equals in
// the limit of small steps. Masses, lengths, times in the study's units. Range: x small against the radii.
#pragma once

#include <limits>

#include "jamscape/contact/options.hpp"
#include "jamscape/geometry/scalar.hpp"
#include "jamscape/geometry/vec.hpp"

namespace jam {

/// Constants of the law for one pair of materials.
template <class T = double>
struct PairLaw {
  T k_n, gamma_n, k_t, gamma_t;
  T inverse_k_t;  ///< 0 where k_t is 0
  T mu;
  T lever_cut;              ///< lever arm = R - lever_cut x: 0 or 1/2
  T floor;                  ///< smallest normal force: -infinity (unclipped) or 0 (clipped)
  bool printed;             ///< F_n = 0 where |dashpot| > |spring|: the rule printed in S2
  bool springless = false;  ///< k_t = 0: the dashpot alone holds a contact tangentially

  template <class U>
  JAM_INLINE PairLaw<U> as() const {
    return {U(k_n), U(gamma_n), U(k_t), U(gamma_t), U(inverse_k_t), U(mu), U(lever_cut), U(floor), printed, springless};
  }
};

/// A quantity of rotation or of the tangential plane: a scalar in two dimensions, a vector in three.
template <int D, class T>
struct AxialOf {
  using type = Vec<3, T>;
};
template <class T>
struct AxialOf<2, T> {
  using type = T;
};
template <int D, class T = double>
using Axial = typename AxialOf<D, T>::type;

template <int D, class T>
struct TouchForce {
  T normal;                ///< F_n
  Axial<D, T> tangential;  ///< f_t on i: along t (2D), or the vector (3D)
  T limit;                 ///< Coulomb limit of |f_t|
  T damped;                ///< power taken by the dashpots (the tangential one while the contact sticks)
  /// Energy taken tangentially in this step. Linear law: by friction alone, all that a sliding contact takes. Hertz
  /// laws: the whole work against the tangential force, springs included, because their energy changes with x as well.
  T rubbed;
};

/// s(x) of the normal law.
template <NormalLaw law, class T>
JAM_INLINE T shape(T x) {
  if constexpr (hertzian(law))
    return square_root(x);
  else
    return T(1.0);
}

/// What stands for mbar in the dashpots.
template <NormalLaw law, class T>
JAM_INLINE T damped_mass(T mbar, T s) {
  if constexpr (law == NormalLaw::tsuji)
    return mbar / square_root(s);
  else if constexpr (law == NormalLaw::ratio)
    return square_root(mbar);
  else
    return mbar;
}

/// Elastic energy of the normal spring: k x^2/2 (linear), 2/5 k x^(5/2) (Hertz).
template <NormalLaw law>
double normal_energy(double k_n, double x) {
  if constexpr (hertzian(law))
    return 0.4 * k_n * x * x * square_root(x);
  else
    return 0.5 * k_n * x * x;
}

/// Elastic energy of the tangential spring at s = 1.
template <class T>
JAM_INLINE T spring_energy(T k_t, T spring) {
  return T(0.5) * k_t * (spring * spring);
}
template <class T>
JAM_INLINE T spring_energy(T k_t, const Vec<3, T>& spring) {
  return T(0.5) * k_t * dot(spring, spring);
}

/// Elastic energies, summed over contacts.
struct ElasticEnergy {
  double normal = 0, tangential = 0;

  /// One contact of overlap x > 0 and tangential spring `spring`.
  template <NormalLaw law, class Spring>
  void add(const PairLaw<>& c, double x, const Spring& spring) {
    normal += normal_energy<law>(c.k_n, x);
    tangential += shape<law>(x) * spring_energy(c.k_t, spring);
  }
};

/// Calls f.operator()<law>() for a law known at run time only.
template <class F>
JAM_INLINE auto with_law(NormalLaw law, F&& f) {
  switch (law) {
    case NormalLaw::hertz:
      return f.template operator()<NormalLaw::hertz>();
    case NormalLaw::tsuji:
      return f.template operator()<NormalLaw::tsuji>();
    case NormalLaw::ratio:
      return f.template operator()<NormalLaw::ratio>();
    case NormalLaw::linear:
      break;
  }
  return f.template operator()<NormalLaw::linear>();
}

/// The normal force alone, before s(x); mbar is damped_mass(), `approach` the speed at which the two come closer, -v_n.
template <class T>
JAM_INLINE T normal_force(const PairLaw<T>& c, T x, T mbar, T approach) {
  const T spring = c.k_n * x, dashpot = c.gamma_n * mbar * approach;
  const T force = larger(spring + dashpot, c.floor);
  return c.printed ? select(magnitude(dashpot) > spring, T(0.0), force) : force;
}

/// The largest tangential force before s(x), `bare` being the normal force before it.
template <NormalLaw law, class T>
JAM_INLINE T coulomb_limit(const PairLaw<T>& c, T x, T bare) {
  if constexpr (law == NormalLaw::ratio)
    return c.mu * (c.k_n * x);
  else
    return c.mu * magnitude(bare);
}

/// Whether a tangential force is larger than `cap`, and what is left of it then.
template <bool fused, class T>
JAM_INLINE auto exceeds(const T& force, const T& cap) {
  return magnitude(force) > cap;
}
template <bool fused, class T>
JAM_INLINE auto exceeds(const Vec<3, T>& force, const T& cap) {
  return dot<fused>(force, force) > cap * cap;
}
template <bool fused, class T>
JAM_INLINE T cut(const T& force, const T& cap) {
  return larger(smaller(force, cap), -cap);
}
template <bool fused, class T>
JAM_INLINE Vec<3, T> cut(const Vec<3, T>& force, const T& cap) {
  const T size2 = dot<fused>(force, force);
  return select(size2 > cap * cap, cap / square_root(size2), T(1.0)) * force;
}

/// Forces of a contact; `spring` is advanced by v_t dt and reset at the Coulomb limit.
/// `lw` = l_i w_i + l_j w_j. Inside, forces are those on i: `dashpot` is -gamma_t mbar v_t, `dash_power` <= 0. `fused`
/// (three dimensions): products that are added are rounded once (geometry/vec.hpp). What only sliding needs is left out
/// where nothing slides.
template <int D, NormalLaw law, bool friction, bool fused = false, class T>
JAM_INLINE TouchForce<D, T> touch(const PairLaw<T>& c, const Vec<D, T>& n, T x, T pair_mass, const Vec<D, T>& v,
                                  const Axial<D, T>& lw, Axial<D, T>& spring, T dt) {
  TouchForce<D, T> out;
  constexpr bool shaped = hertzian(law);
  const T s = shape<law>(x), approach = dot<fused>(v, n), mbar = damped_mass<law>(pair_mass, s);
  const T bare = normal_force(c, x, mbar, approach);
  T elastic = c.k_n * x;
  out.normal = bare;
  if constexpr (shaped) out.normal = s * bare, elastic = s * elastic;
  out.damped = (out.normal - elastic) * approach;
  out.rubbed = T(0.0);
  out.limit = T(0.0);
  if constexpr (!friction) {
    if constexpr (D == 2)
      out.tangential = T(0.0);
    else
      out.tangential = {T(0.0), T(0.0), T(0.0)};
    return out;
  } else {
    const T cap = coulomb_limit<law>(c, x, bare), damping = -c.gamma_t * mbar;
    out.limit = cap;
    if constexpr (shaped) out.limit = s * cap;
    Axial<D, T> v_t, trial;
    if constexpr (D == 2) {
      v_t = n[0] * v[1] - n[1] * v[0] + lw;
      trial = spring + v_t * dt;
    } else {
      v_t = add_cross<fused>(subtract_product<fused>(v, approach, n), lw, n);
      trial = add_product<fused>(spring, dt, v_t);
      trial = subtract_product<fused>(trial, dot<fused>(n, trial), n);
    }
    const Axial<D, T> dashpot = damping * v_t;
    Axial<D, T> force = subtract_product<fused>(dashpot, c.k_t, trial);
    T dash_power = dot<fused>(dashpot, v_t);
    const auto slides = exceeds<fused>(force, cap);
    spring = trial;
    if (any(slides)) {
      force = cut<fused>(force, cap);
      spring = select(slides, c.inverse_k_t * (dashpot - force), trial);
      if constexpr (!shaped) {
        const T lost = T(0.5) * c.k_t * (dot<fused>(trial, trial) - dot<fused>(spring, spring));
        // without a spring to reset, friction takes the power of the dashpot as it was cut
        if (c.springless) dash_power = select(slides, dot<fused>(force, v_t), dash_power);
        out.rubbed = select(slides, lost - dash_power * dt, T(0.0));
        dash_power = select(slides, T(0.0), dash_power);
      }
    }
    if constexpr (shaped) {
      force = s * force;
      out.rubbed = dot<fused>(force, v_t) * -dt;
    } else {
      out.damped = out.damped - dash_power;
    }
    out.tangential = force;
    return out;
  }
}

}  // namespace jam
