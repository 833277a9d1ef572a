// The contact loop for vectors of four or eight pairs. Rows of bodies are loaded whole and transposed in registers,
// forces transposed back and added row by row: no gathers, no scatter conflicts, and the order of sums of the plain
// loop. A vector without a touching pair is left after its distances. Included by one file per vector width.
#pragma once

#include "jamscape/dem/integrate_body.hpp"
#include "jamscape/dem/kernel.hpp"
#include "jamscape/geometry/lanes.hpp"

namespace jam::HWY_NAMESPACE {

template <int D>
JAM_INLINE void add_forces(const PairArrays& p, std::size_t k, const Columns& on_i, const Columns& on_j,
                           std::size_t offset) {
  const Rows a = to_rows(on_i), b = to_rows(on_j);
  for (int l = 0; l < Lanes::width; ++l) {
    add_to(p.forces + p.i[k + static_cast<std::size_t>(l)] * Row<D>::force_stride + offset, a.row[l]);
    add_to(p.forces + p.j[k + static_cast<std::size_t>(l)] * Row<D>::force_stride + offset, b.row[l]);
  }
}

template <int D, NormalLaw law, bool friction, bool shifted>
void pair_loop(const PairArrays& p, const PairRange& range) {
  using R = Row<D>;
  constexpr std::size_t width = static_cast<std::size_t>(Lanes::width);
  constexpr std::size_t parts = block / width;
  const PairLaw<Lanes> c = range.law.template as<Lanes>();
  const Lanes dt(p.dt), zero(0.0), one(1.0);
  Lanes damped[parts], rubbed[parts], virial[parts], deepest[parts];
  for (std::size_t q = 0; q < parts; ++q) {
    damped[q] = Lanes::load(p.tally->damped + q * width);
    rubbed[q] = Lanes::load(p.tally->rubbed + q * width);
    virial[q] = Lanes::load(p.tally->virial + q * width);
    deepest[q] = Lanes::load(p.tally->deepest + q * width);
  }

  for (std::size_t base = range.begin; base < range.end; base += block)
    for (std::size_t q = 0; q < parts; ++q) {
      const std::size_t k = base + q * width;
      double* stored = p.springs + (D == 2 ? k : base * 3 + q * width);
      const Columns a = load_rows(p.rows, p.i + k, R::stride), b = load_rows(p.rows, p.j + k, R::stride);
      Vec<D, Lanes> d;
      if constexpr (shifted) {
        const Columns s = load_rows(p.shifts, p.shift + k, 4);
        for (int e = 0; e < D; ++e) d[e] = (b.c[e] + s.c[e]) - a.c[e];
      } else {
        for (int e = 0; e < D; ++e) d[e] = b.c[e] - a.c[e];
      }
      const Lanes reach = a.c[3] + b.c[3], r2 = dot(d, d);
      const Mask touching = r2 < reach * reach;

      Axial<D, Lanes> spring;
      if constexpr (friction) {
        if constexpr (D == 2)
          spring = Lanes::load(stored);
        else
          for (int e = 0; e < 3; ++e) spring[e] = Lanes::load(stored + static_cast<std::size_t>(e) * block);
      } else {
        if constexpr (D == 2)
          spring = zero;
        else
          spring = {zero, zero, zero};
      }
      Lanes left = zero;  // energy in the springs of pairs that have parted
      if constexpr (friction) {
        if constexpr (D == 2)
          left = Lanes(0.5) * c.k_t * (spring * spring);
        else
          left = Lanes(0.5) * c.k_t * dot(spring, spring);
      }
      if (none(touching)) {
        if constexpr (friction) {
          rubbed[q] = rubbed[q] + left;
          if constexpr (D == 2)
            zero.store(stored);
          else
            for (int e = 0; e < 3; ++e) zero.store(stored + static_cast<std::size_t>(e) * block);
        }
        continue;
      }

      const Columns va = load_rows(p.rows + R::velocity, p.i + k, R::stride);
      const Columns vb = load_rows(p.rows + R::velocity, p.j + k, R::stride);
      Vec<D, Lanes> v;
      for (int e = 0; e < D; ++e) v[e] = va.c[e] - vb.c[e];
      const Lanes r = square_root(r2), x = reach - r;
      const Vec<D, Lanes> n = (one / r) * d;
      const Lanes lever_i = a.c[3] - c.lever_cut * x, lever_j = b.c[3] - c.lever_cut * x;
      Axial<D, Lanes> lw;
      if constexpr (!friction) {
        lw = spring;  // unused
      } else if constexpr (D == 2) {
        lw = lever_i * va.c[2] + lever_j * vb.c[2];
      } else {
        const Columns wa = load_rows(p.rows + R::spin, p.i + k, R::stride);
        const Columns wb = load_rows(p.rows + R::spin, p.j + k, R::stride);
        for (int e = 0; e < 3; ++e) lw[e] = lever_i * wa.c[e] + lever_j * wb.c[e];
      }
      const auto f = touch<D, law, friction>(c, n, x, Lanes::load(p.mbar + k), v, lw, spring, dt);
      damped[q] = damped[q] + select_or_zero(touching, f.damped);
      virial[q] = virial[q] + select_or_zero(touching, f.normal * r);
      deepest[q] = larger(deepest[q], x);

      const Lanes push = -f.normal;
      if constexpr (!friction) {
        Columns on_i, on_j;
        for (int e = 0; e < 4; ++e) {
          on_i.c[e] = e < D ? select_or_zero(touching, push * n[e]) : zero;
          on_j.c[e] = e < D ? -on_i.c[e] : zero;
        }
        add_forces<D>(p, k, on_i, on_j, 0);
      } else if constexpr (D == 2) {
        rubbed[q] = rubbed[q] + select(touching, f.rubbed, left);
        select_or_zero(touching, spring).store(stored);
        const Lanes fx = select_or_zero(touching, push * n[0] - f.tangential * n[1]);
        const Lanes fy = select_or_zero(touching, push * n[1] + f.tangential * n[0]);
        const Lanes ft = select_or_zero(touching, f.tangential);
        add_forces<D>(p, k, {{fx, fy, lever_i * ft, zero}}, {{-fx, -fy, lever_j * ft, zero}}, 0);
      } else {
        rubbed[q] = rubbed[q] + select(touching, f.rubbed, left);
        const Vec<3, Lanes> total = push * n + f.tangential, twist = cross(n, f.tangential);
        Columns on_i, on_j, turn_i, turn_j;
        for (int e = 0; e < 3; ++e) {
          select_or_zero(touching, spring[e]).store(stored + static_cast<std::size_t>(e) * block);
          on_i.c[e] = select_or_zero(touching, total[e]);
          on_j.c[e] = -on_i.c[e];
          const Lanes t = select_or_zero(touching, twist[e]);
          turn_i.c[e] = lever_i * t;
          turn_j.c[e] = lever_j * t;
        }
        on_i.c[3] = on_j.c[3] = turn_i.c[3] = turn_j.c[3] = zero;
        add_forces<D>(p, k, on_i, on_j, 0);
        add_forces<D>(p, k, turn_i, turn_j, 4);
      }
    }

  for (std::size_t q = 0; q < parts; ++q) {
    damped[q].store(p.tally->damped + q * width);
    rubbed[q].store(p.tally->rubbed + q * width);
    virial[q].store(p.tally->virial + q * width);
    deepest[q].store(p.tally->deepest + q * width);
  }
}

template <int D, NormalLaw law, bool friction>
void with_shift(const PairArrays& p, const PairRange& range) {
  p.shift ? pair_loop<D, law, friction, true>(p, range) : pair_loop<D, law, friction, false>(p, range);
}

template <int D>
void pairs(const PairArrays& p, const PairRange& range) {
  if (range.kind == NormalLaw::linear)
    range.friction ? with_shift<D, NormalLaw::linear, true>(p, range)
                   : with_shift<D, NormalLaw::linear, false>(p, range);
  else
    range.friction ? with_shift<D, NormalLaw::hertz, true>(p, range) : with_shift<D, NormalLaw::hertz, false>(p, range);
}

}  // namespace jam::HWY_NAMESPACE
