// The contact loop over pairs few of which touch: the watched ones are tested, and those that touch collected, in
// order, to go through eight at a time. Included by one file per vector width.
#pragma once

#include <bit>

#include "jamscape/dem/pair_stages_wide.hpp"

namespace jam::HWY_NAMESPACE {

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

}  // namespace jam::HWY_NAMESPACE
