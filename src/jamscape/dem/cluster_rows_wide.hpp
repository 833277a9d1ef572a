// Rows of bodies and arms of clusters, four or eight at a time: loaded whole and transposed in registers. Included by
// one file per vector width.
#pragma once

#include "jamscape/dem/cluster_bodies.hpp"
#include "jamscape/geometry/lanes.hpp"

namespace jam::HWY_NAMESPACE::clusters {

inline constexpr std::size_t width = static_cast<std::size_t>(Lanes::width);
using R = ClusterRow;

struct WideArms {
  Segment<Lanes> axis;
  Lanes radius;
};

JAM_INLINE Vec<3, Lanes> vector_of(const Columns& x) { return {x.c[0], x.c[1], x.c[2]}; }

JAM_INLINE WideArms load_arms(const double* arms, const std::uint32_t* index) {
  const Columns c = load_rows(arms, index, R::arm_stride), u = load_rows(arms + 4, index, R::arm_stride);
  return {{vector_of(c), vector_of(u), u.c[3]}, c.c[3]};
}

}  // namespace jam::HWY_NAMESPACE::clusters
