// Motion of clusters, four or eight at a time. Included by one file per vector width.
#pragma once

#include "jamscape/dem/cluster_motion.hpp"
#include "jamscape/dem/cluster_rows_wide.hpp"

namespace jam::HWY_NAMESPACE::clusters {

/// Bodies of even moments of inertia, `width` at a time; blocks with a free top in them, and the rest, one by one.
inline void integrate_wide(MotionArrays& b) {
  static constexpr std::uint32_t lane[8] = {0, 1, 2, 3, 4, 5, 6, 7};
  const Lanes dt(b.dt), zero(0.0);
  std::size_t k = 0;
  for (; k + width <= b.count; k += width) {
    std::uint8_t tops = 0;
    for (std::size_t l = 0; l < width; ++l) tops = static_cast<std::uint8_t>(tops | b.top[k + l]);
    if (tops) {
      for (std::size_t l = 0; l < width; ++l) integrate_body(b, k + l);
      continue;
    }
    for (std::size_t l = 0; l < width; ++l) kick_and_drift(b, k + l);
    double* rows = b.rows + k * R::stride;
    const Columns momentum = load_rows(b.momentum + 4 * k, lane, 4),
                  inverse = load_rows(b.inverse + k * R::force_stride + 4, lane, R::force_stride),
                  orientation = load_rows(rows + R::orientation, lane, R::stride);
    const Lanes reach = load_rows(rows + R::spin, lane, R::stride).c[3];
    const Vec<3, Lanes> spin{momentum.c[0] * inverse.c[0], momentum.c[1] * inverse.c[1], momentum.c[2] * inverse.c[2]};
    const Lanes spin2 = dot(spin, spin);
    const Turn<Lanes> q =
        turn_even(Turn<Lanes>{orientation.c[0], orientation.c[1], orientation.c[2], orientation.c[3]}, spin, spin2, dt);
    const Frame<Lanes> f = frame_of(q);
    const Rows spins = to_rows({spin[0], spin[1], spin[2], reach}), turns = to_rows({q.w, q.x, q.y, q.z});
    const Rows axes[3] = {to_rows({f.x[0], f.x[1], f.x[2], zero}), to_rows({f.y[0], f.y[1], f.y[2], zero}),
                          to_rows({f.z[0], f.z[1], f.z[2], zero})};
    for (std::size_t l = 0; l < width; ++l) {
      hn::Store(spins.row[l], Tag4(), rows + l * R::stride + R::spin);
      hn::Store(turns.row[l], Tag4(), rows + l * R::stride + R::orientation);
      place_arms(b, k + l, {axes[0].row[l].raw, axes[1].row[l].raw, axes[2].row[l].raw});
    }
    const Lanes moved = Lanes::load(b.moved + k) +
                        fastest_point(vector_of(load_rows(rows + R::velocity, lane, R::stride)), spin2, reach) * dt;
    moved.store(b.moved + k);
    b.outrun = b.outrun || lane_bits(moved < Lanes::load(b.skin + k)) != (1u << width) - 1;
  }
  for (; k < b.count; ++k) integrate_body(b, k);
}

}  // namespace jam::HWY_NAMESPACE::clusters
