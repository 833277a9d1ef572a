// What the contact loops do to a vector of four or eight pairs: distances, relative motion, law, sums. Rows of bodies
// are loaded whole and transposed in registers, forces transposed back and added row by row: no gathers, no scatter
// conflicts, and the order of sums of the plain loop. Included by one file per vector width.
#pragma once

#include <cstddef>

#include "jamscape/dem/kernel.hpp"
#include "jamscape/geometry/lanes.hpp"

namespace jam::HWY_NAMESPACE {

inline constexpr std::size_t width = static_cast<std::size_t>(Lanes::width), parts = block / width;

/// Where `width` pairs have their data.
struct PairPointers {
  const std::uint32_t *i, *j;  ///< bodies, or their starts: see `distances`
  const std::uint32_t* shift;
  const double* mbar;
  double* springs;  ///< components `block` apart
};

/// Where the forces of a body begin, in bytes; its row begins at twice that. The processor doubles and adds as it
/// reads. 32 bits hold the starts of 6.7e7 spheres; `grains.count` stays below.
template <int D>
inline constexpr std::uint32_t start_step = Row<D>::force_stride * sizeof(double);
static_assert(Row<2>::stride == 2 * Row<2>::force_stride && Row<3>::stride == 2 * Row<3>::force_stride);

JAM_INLINE double* forces_at(const PairArrays& p, std::uint32_t start) {
  return reinterpret_cast<double*>(reinterpret_cast<std::byte*>(p.forces) + start);
}
JAM_INLINE const double* row_at(const PairArrays& p, std::uint32_t start) {
  return reinterpret_cast<const double*>(reinterpret_cast<const std::byte*>(p.rows) + 2 * std::size_t{start});
}
/// Four doubles of the rows of bodies, `offset` from where they begin.
JAM_INLINE Turned load_pieces(const PairArrays& p, const std::uint32_t* starts, std::size_t offset) {
  return load_turned([&](std::size_t l) { return row_at(p, starts[l]) + offset; });
}

/// The tally in registers: slot q holds lanes q * width ...
struct WideTally {
  Lanes damped[parts], rubbed[parts], virial[parts], deepest[parts];

  JAM_INLINE void load(const Tally& t) {
    for (std::size_t q = 0; q < parts; ++q) {
      damped[q] = Lanes::load(t.damped + q * width);
      rubbed[q] = Lanes::load(t.rubbed + q * width);
      virial[q] = Lanes::load(t.virial + q * width);
      deepest[q] = Lanes::load(t.deepest + q * width);
    }
  }
  JAM_INLINE void store(Tally& t) const {
    for (std::size_t q = 0; q < parts; ++q) {
      damped[q].store(t.damped + q * width);
      rubbed[q].store(t.rubbed + q * width);
      virial[q].store(t.virial + q * width);
      deepest[q].store(t.deepest + q * width);
    }
  }
};

template <int D>
struct Geometry {
  Vec<D, Lanes> d;  ///< from i to j
  Lanes radius_i, radius_j, reach, r2;
  Mask touching;
};

/// Components of a spin, spring or torque.
template <int D>
inline constexpr int axes = D == 2 ? 1 : 3;

template <int D>
JAM_INLINE Lanes& component(Axial<D, Lanes>& a, int e) {
  if constexpr (D == 2)
    return a;
  else
    return a[e];
}
template <int D>
JAM_INLINE const Lanes& component(const Axial<D, Lanes>& a, int e) {
  if constexpr (D == 2)
    return a;
  else
    return a[e];
}

/// What the law needs to know of a pair.
template <int D>
struct Touch {
  Vec<D, Lanes> n;
  Lanes x, r, lever_i, lever_j;
  Vec<D, Lanes> v;     ///< v_i - v_j, and what the box adds
  Axial<D, Lanes> lw;  ///< l_i w_i + l_j w_j; with friction only
  Mask touching;
};

/// `started`: i and j of `at` are starts, not bodies.
template <int D, bool shifted, bool started>
JAM_INLINE void distances(const PairArrays& p, const PairPointers& at, Geometry<D>& g) {
  Turned a, b;
  if constexpr (started)
    a = load_pieces(p, at.i, 0), b = load_pieces(p, at.j, 0);
  else
    a = load_turned(p.rows, at.i, Row<D>::stride), b = load_turned(p.rows, at.j, Row<D>::stride);
  if constexpr (shifted) b = b + load_turned(p.shifts, at.shift, 4);
  const Columns ca = columns(a), cb = columns(b);
  if constexpr (D == 2) {
    for (int e = 0; e < D; ++e) g.d[e] = cb.c[e] - ca.c[e];
  } else {  // subtracted before they are turned
    const Columns d = columns(b - a);
    for (int e = 0; e < D; ++e) g.d[e] = d.c[e];
  }
  g.radius_i = ca.c[3], g.radius_j = cb.c[3];
  g.reach = g.radius_i + g.radius_j;
  g.r2 = dot<fused<D>>(g.d, g.d);
  g.touching = g.r2 < g.reach * g.reach;
}
template <int D, bool shifted, bool started>
JAM_INLINE Geometry<D> distances(const PairArrays& p, const PairPointers& at) {
  Geometry<D> g;
  distances<D, shifted, started>(p, at, g);
  return g;
}

/// i and j of `at` are starts.
template <int D, bool friction>
JAM_INLINE void to_touch(const PairArrays& p, const PairLaw<Lanes>& c, const PairPointers& at, const Geometry<D>& g,
                         Touch<D>& t) {
  using R = Row<D>;
  t.r = square_root(g.r2);
  t.n = (Lanes(1.0) / t.r) * g.d;
  t.x = g.reach - t.r;
  t.lever_i = subtract_product<fused<D>>(g.radius_i, c.lever_cut, t.x);
  t.lever_j = subtract_product<fused<D>>(g.radius_j, c.lever_cut, t.x);
  t.touching = g.touching;
  if constexpr (D == 2) {
    const Columns va = columns(load_pieces(p, at.i, R::velocity)), vb = columns(load_pieces(p, at.j, R::velocity));
    for (int e = 0; e < 2; ++e) t.v[e] = va.c[e] - vb.c[e];
    if constexpr (friction) t.lw = t.lever_i * va.c[2] + t.lever_j * vb.c[2];
  } else {
    const Columns v = columns(load_pieces(p, at.i, R::velocity) - load_pieces(p, at.j, R::velocity));
    for (int e = 0; e < 3; ++e) t.v[e] = v.c[e];
    if constexpr (friction) {
      const Columns wa = columns(load_pieces(p, at.i, R::spin)), wb = columns(load_pieces(p, at.j, R::spin));
      for (int e = 0; e < 3; ++e) t.lw[e] = add_product<fused<D>>(t.lever_j * wb.c[e], t.lever_i, wa.c[e]);
    }
  }
  if (p.shrinking != 0)
    for (int e = 0; e < D; ++e) t.v[e] = add_product<fused<D>>(t.v[e], Lanes(p.shrinking), g.d[e]);
}

/// What `width` pairs do to their bodies: force and turn_i are added to the forces of i, force and back_j subtracted
/// from those of j. Zero where nothing touches.
template <int D>
struct Push {
  Vec<D, Lanes> force;
  Axial<D, Lanes> turn_i, back_j;
};

template <int D>
JAM_INLINE Axial<D, Lanes> load_springs(const double* stored) {
  if constexpr (D == 2)
    return Lanes::load(stored);
  else
    return {Lanes::load(stored), Lanes::load(stored + block), Lanes::load(stored + 2 * block)};
}

/// Books (linear law) and erases the springs of pairs that do not touch.
template <int D, NormalLaw law>
JAM_INLINE void erase_parted(const PairLaw<Lanes>& c, Mask touching, double* stored, Lanes& rubbed) {
  const Axial<D, Lanes> spring = load_springs<D>(stored);
  if constexpr (!hertzian(law)) rubbed = rubbed + select(touching, Lanes(0.0), spring_energy(c.k_t, spring));
  if constexpr (D == 2)
    select_or_zero(touching, spring).store(stored);
  else
    for (int e = 0; e < 3; ++e) select_or_zero(touching, spring[e]).store(stored + static_cast<std::size_t>(e) * block);
}

template <int D, bool friction>
JAM_INLINE void add_push(const PairArrays& p, const PairPointers& at, const Push<D>& f) {
  const Lanes zero(0.0);
  if constexpr (D == 2) {
    const Rows on_i = to_rows({{f.force[0], f.force[1], friction ? f.turn_i : zero, zero}}),
               off_j = to_rows({{f.force[0], f.force[1], friction ? f.back_j : zero, zero}});
    for (std::size_t l = 0; l < width; ++l) {
      add_to(forces_at(p, at.i[l]), on_i.row[l]);
      subtract_from(forces_at(p, at.j[l]), off_j.row[l]);
    }
  } else {
    // force and torque of a body side by side: one sum of eight doubles
    const Turned force = turned({{f.force[0], f.force[1], f.force[2], zero}});
    Turned turn_i = turned({{zero, zero, zero, zero}}), back_j = turn_i;
    if constexpr (friction) {
      turn_i = turned({{f.turn_i[0], f.turn_i[1], f.turn_i[2], zero}});
      back_j = turned({{f.back_j[0], f.back_j[1], f.back_j[2], zero}});
    }
    for (std::size_t l = 0; l < width; ++l) {
      add_two_to(forces_at(p, at.i[l]), force, turn_i, l);
      subtract_two_from(forces_at(p, at.j[l]), force, back_j, l);
    }
  }
}

/// The law for the pairs of one vector; the springs of those that touch are advanced.
template <int D, NormalLaw law, bool friction>
JAM_INLINE void push_of(const PairArrays& p, const PairLaw<Lanes>& c, const PairPointers& at, const Touch<D>& t,
                        WideTally& tally, std::size_t q, Push<D>& push) {
  Axial<D, Lanes> spring{};
  if constexpr (friction) spring = load_springs<D>(at.springs);
  const auto f = touch<D, law, friction, fused<D>>(c, t.n, t.x, Lanes::load(at.mbar), t.v, t.lw, spring, Lanes(p.dt));
  tally.damped[q] = tally.damped[q] + select_or_zero(t.touching, f.damped);
  tally.virial[q] = select(t.touching, add_product<fused<D>>(tally.virial[q], f.normal, t.r), tally.virial[q]);
  tally.deepest[q] = larger(tally.deepest[q], t.x);
  if constexpr (friction) {
    tally.rubbed[q] = tally.rubbed[q] + select_or_zero(t.touching, f.rubbed);
    for (int e = 0; e < axes<D>; ++e) {
      double* stored = at.springs + static_cast<std::size_t>(e) * block;
      select(t.touching, component<D>(spring, e), Lanes::load(stored)).store(stored);
    }
  }

  if constexpr (!friction) {
    for (int e = 0; e < D; ++e) push.force[e] = select_or_zero(t.touching, -(f.normal * t.n[e]));
  } else if constexpr (D == 2) {
    push.force[0] = select_or_zero(t.touching, -f.normal * t.n[0] - f.tangential * t.n[1]);
    push.force[1] = select_or_zero(t.touching, f.tangential * t.n[0] - f.normal * t.n[1]);
    const Lanes along = select_or_zero(t.touching, f.tangential);
    push.turn_i = t.lever_i * along, push.back_j = -t.lever_j * along;
  } else {
    const Vec<3, Lanes> twist = cross<fused<D>>(t.n, f.tangential);
    const Lanes back = -t.lever_j;
    for (int e = 0; e < 3; ++e) {
      push.force[e] = select_or_zero(t.touching, subtract_product<fused<D>>(f.tangential[e], f.normal, t.n[e]));
      const Lanes turn = select_or_zero(t.touching, twist[e]);
      push.turn_i[e] = t.lever_i * turn, push.back_j[e] = back * turn;
    }
  }
}

template <int D>
JAM_INLINE double* spring_of(const PairArrays& p, std::size_t k) {
  return p.springs + (D == 2 ? k : k / block * 3 * block + k % block);
}

template <int D, bool shifted>
JAM_INLINE PairPointers pointers(const PairArrays& p, std::size_t k) {
  return {p.i + k, p.j + k, shifted ? p.shift + k : nullptr, p.mbar + k, spring_of<D>(p, k)};
}

}  // namespace jam::HWY_NAMESPACE
