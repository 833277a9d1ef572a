// The contact loop over pairs most of which touch. Included by one file per vector width.
#pragma once

#include <bit>

#include "jamscape/dem/pair_stages_wide.hpp"

namespace jam::HWY_NAMESPACE {

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

/// Stages: distances, relative motion, law, sums. In each turn every stage has one vector, the oldest first, so that
/// none waits for another and what is handed on has one place. Results of a stage are built in place: they are large.
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

}  // namespace jam::HWY_NAMESPACE
