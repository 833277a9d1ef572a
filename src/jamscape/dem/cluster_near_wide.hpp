// Which arm pairs touch or are near, four or eight at a time. Included by one file per vector width.
#pragma once

#include <bit>

#include "jamscape/dem/cluster_kernel.hpp"
#include "jamscape/dem/cluster_rows_wide.hpp"

namespace jam::HWY_NAMESPACE::clusters {

/// Which of `width` pairs are nearer than their radii and `skin`, as bits.
JAM_INLINE std::uint32_t near_bits(const double* arms, const std::uint32_t* arm_i, const std::uint32_t* arm_j,
                                   Lanes skin) {
  const WideArms one = load_arms(arms, arm_i), two = load_arms(arms, arm_j);
  const Lanes reach = one.radius + two.radius + skin;
  return lane_bits(closest_points(one.axis, two.axis).distance2 < reach * reach);
}

/// Writes from, from + 1, ... where `bits` are set. Returns how many.
JAM_INLINE std::size_t store_set(std::size_t from, std::uint32_t bits, std::uint32_t* to) {
  constexpr hn::CappedTag<std::uint32_t, width> d;
  const std::uint8_t padded[8] = {static_cast<std::uint8_t>(bits)};
  hn::CompressBitsStore(hn::Iota(d, static_cast<std::uint32_t>(from)), padded, d, to);
  return static_cast<std::size_t>(std::popcount(bits));
}

inline std::size_t near(const NearArms& arrays) {
  const NearArms p = arrays;  // pointers that no store can change
  std::size_t count = 0;
  for (std::size_t k = 0; k < p.count; k += width)
    count += store_set(k, near_bits(p.arms, p.arm_i + k, p.arm_j + k, Lanes::load(p.skin + k)), p.near + count);
  return count;
}

inline std::size_t collect(const CollectArrays& arrays) {
  const CollectArrays p = arrays;
  std::size_t count = 0;
  for (std::size_t k = 0; k < p.pairs; k += block) {
    std::uint32_t all = 0;
    for (std::size_t from = k; from < k + block; from += width) {
      const std::uint32_t bits = near_bits(p.arms, p.arm_i + from, p.arm_j + from, Lanes(0.0));
      count += store_set(from, bits, p.pair + count);
      all |= bits << (from - k);
    }
    p.touching[k / block] = static_cast<std::uint8_t>(all);
  }
  return count;
}

}  // namespace jam::HWY_NAMESPACE::clusters
