// The search for near bodies, four or eight candidates at a time. Included by one file per vector width.
#pragma once

#include "jamscape/dem/near_bodies.hpp"
#include "jamscape/dem/rows.hpp"
#include "jamscape/geometry/lanes.hpp"
#include "jamscape/geometry/vec.hpp"

namespace jam::HWY_NAMESPACE {

template <int D>
std::size_t near(const NearQuery& query, const NearBodies& out) {
  constexpr hn::CappedTag<std::uint32_t, Lanes::width> d;
  const NearQuery s = query;  // pointers that no store can change
  const Lanes radius(s.row[Row<D>::radius]), skin(s.skin);
  const auto a = hn::Set(d, s.a), touching = hn::Set(d, NearBodies::touching);
  std::size_t n = 0;
  for (std::size_t r = 0; r < s.range_count; ++r) {
    const CandidateRange range = s.ranges[r];
    const double* shift = s.shifts + 4 * range.shift;
    const auto image = hn::Set(d, range.shift);
    for (std::uint32_t q = range.from; q < range.to; q += Lanes::width) {
      Vec<D, Lanes> between;
      for (int e = 0; e < D; ++e) between[e] = (Lanes::load_anywhere(s.x[e] + q) + Lanes(shift[e])) - Lanes(s.row[e]);
      const Lanes r2 = dot(between, between), reach = radius + Lanes::load_anywhere(s.radius + q), far = reach + skin;
      const auto body = hn::LoadU(d, s.body + q);
      const std::uint32_t left = range.to - q, in_range = left < Lanes::width ? (1u << left) - 1 : 0xffu;
      const auto near =
          static_cast<std::uint8_t>(lane_bits(r2 < far * far) & bits_of_lanes(d, hn::Gt(body, a)) & in_range);
      const auto marked = hn::Or(body, hn::IfThenElseZero(lanes_of_bits(d, lane_bits(r2 < reach * reach)), touching));
      const std::uint8_t padded[8] = {near};
      hn::CompressBitsStore(marked, padded, d, out.body + n);
      hn::StoreU(image, d, out.shift + n);
      n += static_cast<std::size_t>(__builtin_popcount(near));
    }
  }
  return n;
}

}  // namespace jam::HWY_NAMESPACE
