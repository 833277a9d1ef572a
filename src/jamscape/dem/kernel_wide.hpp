// The passes for vectors of four or eight. Included by one file per vector width.
#pragma once

#include "jamscape/dem/dense_loop_wide.hpp"
#include "jamscape/dem/integrate_body.hpp"
#include "jamscape/dem/near_wide.hpp"
#include "jamscape/dem/sparse_loop_wide.hpp"

namespace jam::HWY_NAMESPACE {

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

constexpr Kernels kernels_named(const char* name) {
  return {name, pairs<2>, pairs<3>, watch<2>, watch<3>, near<2>, near<3>, verlet<2>, verlet<3>, gear<2>, gear<3>};
}

}  // namespace jam::HWY_NAMESPACE
