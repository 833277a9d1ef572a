// The contact loop for vectors of four or eight pairs. Rows of bodies are loaded whole and transposed in registers,
// forces transposed back and added row by row: no gathers, no scatter conflicts, and the order of sums of the plain
// loop. In a dense range three or four vectors are on their way at a time, one in each stage; they do not wait for
// each other. In a sparse range the watched pairs are tested, and those that touch collected, in order, to
// go through eight at a time. Included by one file per vector width.
#pragma once

#include <bit>
#include <cstddef>
#include <new>

#include "jamscape/dem/integrate_body.hpp"
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
  Vec<D, Lanes> v;     ///< v_i - v_j
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

/// Touching pairs on their way into a block of their own. Lanes before `first` are done.
template <int D>
struct alignas(64) Collected {
  static constexpr std::size_t components = axes<D>;
  double springs[components * block], mbar[block];
  double* home[block];               ///< of the springs
  std::uint32_t i[block], j[block];  ///< starts
  std::uint32_t shift[block];
  std::size_t first = 0, count = 0;

  JAM_INLINE void add(const PairArrays& p, std::size_t k, double* stored) {
    i[count] = p.i[k] * start_step<D>, j[count] = p.j[k] * start_step<D>, mbar[count] = p.mbar[k], home[count] = stored;
    if (p.shift) shift[count] = p.shift[k];
    for (std::size_t e = 0; e < components; ++e) springs[e * block + count] = stored[e * block];
    ++count;
  }
};

template <int D, NormalLaw law, bool friction, bool shifted>
void flush(const PairArrays& p, const PairLaw<Lanes>& c, Collected<D>& pending, WideTally& tally) {
  const std::size_t first = pending.first, count = pending.count;
  if (first == count) return;
  for (std::size_t k = 0; k < block; ++k) {  // the rest: a pair that touches nothing to write to, masked below
    if (k >= first && k < count) continue;
    pending.i[k] = pending.i[first], pending.j[k] = pending.j[first], pending.mbar[k] = pending.mbar[first];
    pending.shift[k] = pending.shift[first];
    for (std::size_t e = 0; e < Collected<D>::components; ++e) pending.springs[e * block + k] = 0;
  }
  const std::uint32_t live = ((1u << count) - 1) & ~((1u << first) - 1);
  for (std::size_t q = 0; q < parts; ++q) {
    const std::uint32_t bits = live >> (q * width) & ((1u << width) - 1);
    if (!bits) continue;
    const PairPointers at{pending.i + q * width, pending.j + q * width, pending.shift + q * width,
                          pending.mbar + q * width, pending.springs + q * width};
    Touch<D> t;
    to_touch<D, friction>(p, c, at, distances<D, shifted, true>(p, at), t);
    t.touching = lanes_of(static_cast<std::uint8_t>(bits));
    Push<D> push;
    push_of<D, law, friction>(p, c, at, t, tally, q, push);
    add_push<D, friction>(p, at, push);
  }
  if constexpr (friction)
    for (std::size_t k = first; k < count; ++k)
      for (std::size_t e = 0; e < Collected<D>::components; ++e)
        pending.home[k][e * block] = pending.springs[e * block + k];
  pending.first = pending.count = count % block;
}

template <int D>
JAM_INLINE double* spring_of(const PairArrays& p, std::size_t k) {
  return p.springs + (D == 2 ? k : k / block * 3 * block + k % block);
}

template <int D, bool shifted>
JAM_INLINE PairPointers pointers(const PairArrays& p, std::size_t k) {
  return {p.i + k, p.j + k, shifted ? p.shift + k : nullptr, p.mbar + k, spring_of<D>(p, k)};
}

// What a stage hands to the next; `bits`: the pairs that touch.
template <int D>
struct Met {
  Geometry<D> geometry;
  std::uint32_t bits = 0;
};
template <int D>
struct Moving {
  Touch<D> touch;
  std::uint32_t bits = 0;
};
template <int D>
struct Pushed {
  Push<D> push;
  std::uint32_t bits = 0;
};

/// Rows and forces that take more bytes than this (half of a usual second-level cache) are called into the cache
/// `ahead` vectors before the first stage needs them.
inline constexpr std::size_t fits_cache = 1 << 20, ahead = 4;

template <int D>
JAM_INLINE void fetch_ahead(const PairArrays& p, const std::uint32_t* bodies) {
  using R = Row<D>;
  for (std::size_t l = 0; l < width; ++l) {
    for (std::size_t c = 0; c < R::stride; c += 8) __builtin_prefetch(p.rows + bodies[l] * R::stride + c);
    __builtin_prefetch(p.forces + bodies[l] * R::force_stride, 1);
  }
}

template <int D>
JAM_INLINE void to_starts(const std::uint32_t* bodies, std::uint32_t* starts) {
  constexpr hn::CappedTag<std::uint32_t, width> d;
  hn::Store(hn::ShiftLeft<std::countr_zero(start_step<D>)>(hn::Load(d, bodies)), d, starts);
}

/// Stages: distances, relative motion, law, sums. In each turn every stage has one vector, the oldest first, so that none
/// waits for another and what is handed on has one place. Results of a stage are built in place: they are large.
template <int D, NormalLaw law, bool friction, bool shifted>
void dense_loop(const PairArrays& arrays, const PairRange& range, const PairLaw<Lanes>& c, WideTally& tally) {
  constexpr std::uint32_t all = (1u << width) - 1;
  const PairArrays p = arrays;  // pointers that no store can change
  const std::size_t begin = range.begin, end = range.end;
  const bool out_of_cache = p.nobody * (Row<D>::stride + Row<D>::force_stride) * sizeof(double) > fits_cache;
  struct alignas(64) Starts {
    std::uint32_t i[block], j[block];
  } starts[4];
  Met<D> met;
  Moving<D> moving;
  Pushed<D> pushed;
  const auto where = [&](std::size_t k) -> PairPointers {
    const Starts& s = starts[k / width % 4];
    return {s.i, s.j, shifted ? p.shift + k : nullptr, p.mbar + k, spring_of<D>(p, k)};
  };
  for (std::size_t k = begin; k < end + 3 * width; k += width) {
    if (out_of_cache && k + ahead * width < end) fetch_ahead<D>(p, p.j + k + ahead * width);
    if (pushed.bits) add_push<D, friction>(p, where(k - 3 * width), pushed.push);
    pushed.bits = moving.bits;
    if (k >= begin + 2 * width && k < end + 2 * width) {
      const std::size_t m = k - 2 * width;
      if (moving.bits) push_of<D, law, friction>(p, c, where(m), moving.touch, tally, m / width % parts, pushed.push);
      if constexpr (friction)
        if (moving.bits != all)
          erase_parted<D, law>(c, lanes_of(static_cast<std::uint8_t>(moving.bits)), spring_of<D>(p, m),
                               tally.rubbed[m / width % parts]);
    }
    moving.bits = met.bits;
    if (met.bits) to_touch<D, friction>(p, c, where(k - width), met.geometry, moving.touch);
    met.bits = 0;
    if (k < end) {
      const PairPointers at{p.i + k, p.j + k, shifted ? p.shift + k : nullptr, nullptr, nullptr};
      distances<D, shifted, false>(p, at, met.geometry);  // does not wait for the starts
      Starts& s = starts[k / width % 4];
      to_starts<D>(p.i + k, s.i);
      to_starts<D>(p.j + k, s.j);
      met.bits = lane_bits(met.geometry.touching);
    }
  }
}

/// Erases the spring of a pair k that has parted; the linear law books its energy, in its turn.
template <int D, NormalLaw law, bool shifted>
void forget(const PairArrays& p, const PairLaw<Lanes>& c, std::size_t k, Collected<D>& pending, WideTally& tally) {
  double* stored = spring_of<D>(p, k);
  if constexpr (!hertzian(law)) {
    alignas(64) double book[axes<D>][block] = {};
    for (std::size_t e = 0; e < axes<D>; ++e) book[e][k % width] = stored[e * block];
    flush<D, law, true, shifted>(p, c, pending, tally);
    Axial<D, Lanes> spring;
    for (int e = 0; e < axes<D>; ++e) component<D>(spring, e) = Lanes::load(book[e]);
    Lanes& rubbed = tally.rubbed[k / width % parts];
    rubbed = rubbed + spring_energy(c.k_t, spring);
  }
  for (std::size_t e = 0; e < axes<D>; ++e) stored[e * block] = 0;
}

template <int D, NormalLaw law, bool friction, bool shifted>
void sparse_loop(const PairArrays& p, const PairRange& range, const PairLaw<Lanes>& c, WideTally& tally) {
  Collected<D> pending;
  const WatchArrays& w = p.watch;
  for (std::size_t q = range.begin; q < range.begin + range.watched; q += block) {
    std::uint32_t touching = 0;
    for (std::size_t l = 0; l < block; l += width) {
      const PairPointers at{w.i + q + l, w.j + q + l, shifted ? w.shift + q + l : nullptr, nullptr, nullptr};
      touching |= lane_bits(distances<D, shifted, false>(p, at).touching) << l;
    }
    const std::uint32_t parted = w.touching[q / block] & ~touching;
    if (!(touching | parted)) continue;
    w.touching[q / block] = static_cast<std::uint8_t>(touching);
    for (std::uint32_t bits = touching | (friction ? parted : 0); bits; bits &= bits - 1) {
      const auto l = static_cast<std::size_t>(__builtin_ctz(bits));
      const std::size_t k = w.pair[q + l];
      if constexpr (friction)
        if (parted >> l & 1) {
          forget<D, law, shifted>(p, c, k, pending, tally);
          continue;
        }
      pending.add(p, k, spring_of<D>(p, k));
      if (pending.count == block) flush<D, law, friction, shifted>(p, c, pending, tally);
    }
  }
  flush<D, law, friction, shifted>(p, c, pending, tally);
}

/// Those of `width` pairs that hold a spring.
template <int D>
JAM_INLINE std::uint32_t sprung(const double* stored) {
  const Axial<D, Lanes> spring = load_springs<D>(stored);
  std::uint32_t bits = 0;
  for (int e = 0; e < axes<D>; ++e) bits |= lane_bits(magnitude(component<D>(spring, e)) > Lanes(0.0));
  return bits;
}

template <int D, bool shifted>
std::size_t watch_range(const PairArrays& p, const PairRange& range, double margin) {
  const WatchArrays& w = p.watch;
  std::size_t to = range.begin;
  for (std::size_t k = range.begin; k < range.end; k += width) {
    const PairPointers at = pointers<D, shifted>(p, k);
    const Geometry<D> g = distances<D, shifted, false>(p, at);
    const Lanes far = g.reach + Lanes(margin);
    const std::uint32_t held = sprung<D>(at.springs);
    for (std::uint32_t bits = lane_bits(g.r2 < far * far) | held; bits; bits &= bits - 1) {
      const auto l = static_cast<std::size_t>(__builtin_ctz(bits));
      w.i[to] = p.i[k + l], w.j[to] = p.j[k + l], w.pair[to] = static_cast<std::uint32_t>(k + l);
      if constexpr (shifted) w.shift[to] = p.shift[k + l];
      if (to % block == 0) w.touching[to / block] = 0;
      w.touching[to / block] = static_cast<std::uint8_t>(w.touching[to / block] | (held >> l & 1) << to % block);
      ++to;
    }
  }
  for (; to % block; ++to) {
    w.i[to] = p.nobody, w.j[to] = p.nobody + 1;
    if constexpr (shifted) w.shift[to] = 0;
  }
  return to - range.begin;
}

template <int D>
std::size_t watch(const PairArrays& p, const PairRange& range, double margin) {
  return p.shift ? watch_range<D, true>(p, range, margin) : watch_range<D, false>(p, range, margin);
}

template <int D, NormalLaw law, bool friction, bool shifted>
void pair_loop(const PairArrays& p, const PairRange& range) {
  const PairLaw<Lanes> c = range.law.template as<Lanes>();
  WideTally tally;
  tally.load(*p.tally);
  range.sparse ? sparse_loop<D, law, friction, shifted>(p, range, c, tally)
               : dense_loop<D, law, friction, shifted>(p, range, c, tally);
  tally.store(*p.tally);
}

template <int D, NormalLaw law, bool friction>
void with_shift(const PairArrays& p, const PairRange& range) {
  p.shift ? pair_loop<D, law, friction, true>(p, range) : pair_loop<D, law, friction, false>(p, range);
}

template <int D>
void pairs(const PairArrays& p, const PairRange& range) {
  with_law(range.kind, [&]<NormalLaw law>() {
    range.friction ? with_shift<D, law, true>(p, range) : with_shift<D, law, false>(p, range);
  });
}

}  // namespace jam::HWY_NAMESPACE
