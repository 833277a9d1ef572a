// The contact loop for vectors of four or eight pairs. Rows of bodies are loaded whole and transposed in registers,
// forces transposed back and added row by row: no gathers, no scatter conflicts, and the order of sums of the plain
// loop. In a dense range a vector goes straight through. In a sparse one distances come first; the pairs that touch are
// collected, in order, and go through eight at a time. Included by one file per vector width.
#pragma once

#include "jamscape/dem/integrate_body.hpp"
#include "jamscape/dem/kernel.hpp"
#include "jamscape/geometry/lanes.hpp"

namespace jam::HWY_NAMESPACE {

inline constexpr std::size_t width = static_cast<std::size_t>(Lanes::width), parts = block / width;

/// Where `width` pairs have their data.
struct PairPointers {
  const std::uint32_t *i, *j, *shift;
  const double* mbar;
  double* springs;  ///< components `block` apart
};

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

/// What the forces need to know of the geometry.
template <int D>
struct Touch {
  Vec<D, Lanes> n;
  Lanes x, r, radius_i, radius_j;
  Mask touching;
};

template <int D>
JAM_INLINE Touch<D> to_touch(const Geometry<D>& g) {
  const Lanes r = square_root(g.r2);
  return {(Lanes(1.0) / r) * g.d, g.reach - r, r, g.radius_i, g.radius_j, g.touching};
}

/// Touches on their way from the first pass over a chunk to the second.
template <int D>
struct alignas(64) Staged {
  static constexpr std::size_t pairs = 16 * block;
  double n[D][pairs], x[pairs], r[pairs], radius_i[pairs], radius_j[pairs];
  std::uint8_t touching[pairs / width];

  JAM_INLINE void put(std::size_t k, const Touch<D>& t) {
    for (int e = 0; e < D; ++e) t.n[e].store(n[e] + k);
    t.x.store(x + k), t.r.store(r + k), t.radius_i.store(radius_i + k), t.radius_j.store(radius_j + k);
  }
  JAM_INLINE Touch<D> get(std::size_t k) const {
    Touch<D> t;
    for (int e = 0; e < D; ++e) t.n[e] = Lanes::load(n[e] + k);
    t.x = Lanes::load(x + k), t.r = Lanes::load(r + k);
    t.radius_i = Lanes::load(radius_i + k), t.radius_j = Lanes::load(radius_j + k);
    t.touching = lanes_of(touching[k / width]);
    return t;
  }
};

template <int D, bool shifted>
JAM_INLINE Geometry<D> distances(const PairArrays& p, const PairPointers& at) {
  const Columns a = load_rows(p.rows, at.i, Row<D>::stride), b = load_rows(p.rows, at.j, Row<D>::stride);
  Geometry<D> g;
  if constexpr (shifted) {
    const Columns s = load_rows(p.shifts, at.shift, 4);
    for (int e = 0; e < D; ++e) g.d[e] = (b.c[e] + s.c[e]) - a.c[e];
  } else {
    for (int e = 0; e < D; ++e) g.d[e] = b.c[e] - a.c[e];
  }
  g.radius_i = a.c[3];
  g.radius_j = b.c[3];
  g.reach = g.radius_i + g.radius_j;
  g.r2 = dot(g.d, g.d);
  g.touching = g.r2 < g.reach * g.reach;
  return g;
}

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
  if constexpr (law == NormalLaw::linear) rubbed = rubbed + select(touching, Lanes(0.0), spring_energy(c.k_t, spring));
  if constexpr (D == 2)
    select_or_zero(touching, spring).store(stored);
  else
    for (int e = 0; e < 3; ++e) select_or_zero(touching, spring[e]).store(stored + static_cast<std::size_t>(e) * block);
}

template <int D>
JAM_INLINE void add_forces(const PairArrays& p, const PairPointers& at, const Columns& on_i, const Columns& on_j,
                           std::size_t offset) {
  const Rows a = to_rows(on_i), b = to_rows(on_j);
  for (std::size_t l = 0; l < width; ++l) {
    add_to(p.forces + at.i[l] * Row<D>::force_stride + offset, a.row[l]);
    add_to(p.forces + at.j[l] * Row<D>::force_stride + offset, b.row[l]);
  }
}

/// Forces of the touching pairs of one vector, whose springs are advanced.
template <int D, NormalLaw law, bool friction>
JAM_INLINE void forces(const PairArrays& p, const PairLaw<Lanes>& c, const PairPointers& at, const Touch<D>& g,
                       WideTally& tally, std::size_t q) {
  using R = Row<D>;
  const Lanes zero(0.0);
  const Mask touching = g.touching;
  const Columns va = load_rows(p.rows + R::velocity, at.i, R::stride),
                vb = load_rows(p.rows + R::velocity, at.j, R::stride);
  Vec<D, Lanes> v;
  for (int e = 0; e < D; ++e) v[e] = va.c[e] - vb.c[e];
  const Lanes r = g.r, x = g.x;
  const Vec<D, Lanes>& n = g.n;
  const Lanes lever_i = g.radius_i - c.lever_cut * x, lever_j = g.radius_j - c.lever_cut * x;
  Axial<D, Lanes> spring, lw;
  if constexpr (friction) {
    spring = load_springs<D>(at.springs);
    if constexpr (D == 2) {
      lw = lever_i * va.c[2] + lever_j * vb.c[2];
    } else {
      const Columns wa = load_rows(p.rows + R::spin, at.i, R::stride),
                    wb = load_rows(p.rows + R::spin, at.j, R::stride);
      for (int e = 0; e < 3; ++e) lw[e] = lever_i * wa.c[e] + lever_j * wb.c[e];
    }
  } else if constexpr (D == 2) {
    spring = lw = zero;
  } else {
    spring = lw = {zero, zero, zero};
  }
  const auto f = touch<D, law, friction>(c, n, x, Lanes::load(at.mbar), v, lw, spring, Lanes(p.dt));
  tally.damped[q] = tally.damped[q] + select_or_zero(touching, f.damped);
  tally.virial[q] = tally.virial[q] + select_or_zero(touching, f.normal * r);
  tally.deepest[q] = larger(tally.deepest[q], x);

  const Lanes push = -f.normal;
  if constexpr (!friction) {
    Columns on_i, on_j;
    for (int e = 0; e < 4; ++e) {
      on_i.c[e] = e < D ? select_or_zero(touching, push * n[e]) : zero;
      on_j.c[e] = e < D ? -on_i.c[e] : zero;
    }
    add_forces<D>(p, at, on_i, on_j, 0);
  } else if constexpr (D == 2) {
    tally.rubbed[q] = tally.rubbed[q] + select_or_zero(touching, f.rubbed);
    select(touching, spring, Lanes::load(at.springs)).store(at.springs);
    const Lanes fx = select_or_zero(touching, push * n[0] - f.tangential * n[1]);
    const Lanes fy = select_or_zero(touching, push * n[1] + f.tangential * n[0]);
    const Lanes ft = select_or_zero(touching, f.tangential);
    add_forces<D>(p, at, {{fx, fy, lever_i * ft, zero}}, {{-fx, -fy, lever_j * ft, zero}}, 0);
  } else {
    tally.rubbed[q] = tally.rubbed[q] + select_or_zero(touching, f.rubbed);
    const Vec<3, Lanes> total = push * n + f.tangential, twist = cross(n, f.tangential);
    Columns on_i, on_j, turn_i, turn_j;
    for (int e = 0; e < 3; ++e) {
      double* stored = at.springs + static_cast<std::size_t>(e) * block;
      select(touching, spring[e], Lanes::load(stored)).store(stored);
      on_i.c[e] = select_or_zero(touching, total[e]);
      on_j.c[e] = -on_i.c[e];
      const Lanes t = select_or_zero(touching, twist[e]);
      turn_i.c[e] = lever_i * t;
      turn_j.c[e] = lever_j * t;
    }
    on_i.c[3] = on_j.c[3] = turn_i.c[3] = turn_j.c[3] = zero;
    add_forces<D>(p, at, on_i, on_j, 0);
    add_forces<D>(p, at, turn_i, turn_j, 4);
  }
}

/// Touching pairs on their way into a block of their own.
template <int D>
struct alignas(64) Collected {
  static constexpr std::size_t components = D == 2 ? 1 : 3;
  double springs[components * block], mbar[block];
  double* home[block];  ///< of the springs
  std::uint32_t i[block], j[block], shift[block];
  std::size_t count = 0;

  JAM_INLINE void add(const PairArrays& p, std::size_t k, double* stored) {
    i[count] = p.i[k], j[count] = p.j[k], mbar[count] = p.mbar[k], home[count] = stored;
    if (p.shift) shift[count] = p.shift[k];
    for (std::size_t e = 0; e < components; ++e) springs[e * block + count] = stored[e * block];
    ++count;
  }
};

template <int D, NormalLaw law, bool friction, bool shifted>
void flush(const PairArrays& p, const PairLaw<Lanes>& c, Collected<D>& pending, WideTally& tally) {
  const std::size_t count = pending.count;
  for (; pending.count < block; ++pending.count) {  // the rest: a pair that touches nothing to write to, masked below
    const std::size_t k = pending.count;
    pending.i[k] = pending.i[0], pending.j[k] = pending.j[0], pending.mbar[k] = pending.mbar[0];
    pending.shift[k] = pending.shift[0];
    for (std::size_t e = 0; e < Collected<D>::components; ++e) pending.springs[e * block + k] = 0;
  }
  for (std::size_t q = 0; q < parts && q * width < count; ++q) {
    const PairPointers at{pending.i + q * width, pending.j + q * width, pending.shift + q * width,
                          pending.mbar + q * width, pending.springs + q * width};
    Touch<D> g = to_touch(distances<D, shifted>(p, at));
    g.touching = first_lanes(static_cast<int>(count - q * width));
    forces<D, law, friction>(p, c, at, g, tally, q);
  }
  if constexpr (friction)
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t e = 0; e < Collected<D>::components; ++e)
        pending.home[k][e * block] = pending.springs[e * block + k];
  pending.count = 0;
}

template <int D, bool shifted>
JAM_INLINE PairPointers pointers(const PairArrays& p, std::size_t k) {
  return {p.i + k, p.j + k, shifted ? p.shift + k : nullptr, p.mbar + k,
          p.springs + (D == 2 ? k : k / block * 3 * block + k % block)};
}

template <int D, NormalLaw law, bool friction, bool shifted>
void dense_loop(const PairArrays& p, const PairRange& range, const PairLaw<Lanes>& c, WideTally& tally) {
  Staged<D> staged;
  for (std::size_t first = range.begin; first < range.end; first += staged.pairs) {
    const std::size_t count = range.end - first < staged.pairs ? range.end - first : staged.pairs;
    for (std::size_t k = 0; k < count; k += width) {
      const PairPointers at = pointers<D, shifted>(p, first + k);
      const Geometry<D> g = distances<D, shifted>(p, at);
      const std::uint32_t bits = lane_bits(g.touching);
      staged.touching[k / width] = static_cast<std::uint8_t>(bits);
      staged.put(k, to_touch(g));
      if constexpr (friction)
        if (bits != (1u << width) - 1) erase_parted<D, law>(c, g.touching, at.springs, tally.rubbed[k / width % parts]);
    }
    for (std::size_t k = 0; k < count; k += width)
      if (staged.touching[k / width])
        forces<D, law, friction>(p, c, pointers<D, shifted>(p, first + k), staged.get(k), tally, k / width % parts);
  }
}

template <int D, NormalLaw law, bool friction, bool shifted>
void sparse_loop(const PairArrays& p, const PairRange& range, const PairLaw<Lanes>& c, WideTally& tally) {
  Collected<D> pending;
  for (std::size_t k = range.begin; k < range.end; k += width) {
    const PairPointers at = pointers<D, shifted>(p, k);
    const Geometry<D> g = distances<D, shifted>(p, at);
    if constexpr (friction) erase_parted<D, law>(c, g.touching, at.springs, tally.rubbed[k / width % parts]);
    if (none(g.touching)) continue;
    for (std::uint32_t bits = lane_bits(g.touching); bits; bits &= bits - 1) {
      const auto l = static_cast<std::size_t>(__builtin_ctz(bits));
      pending.add(p, k + l, at.springs + l);
      if (pending.count == block) flush<D, law, friction, shifted>(p, c, pending, tally);
    }
  }
  if (pending.count) flush<D, law, friction, shifted>(p, c, pending, tally);
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
