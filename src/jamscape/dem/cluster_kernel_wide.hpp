// The passes over arm pairs for vectors of four or eight. Rows are loaded whole and transposed in registers, forces
// transposed back and added row by row in the order of the plain loop. Pairs that touch are collected first, so that
// the law works on full vectors. Included by one file per vector width.
#pragma once

#include "jamscape/dem/cluster_contact.hpp"
#include "jamscape/dem/cluster_motion.hpp"
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

inline std::size_t collect(const CollectArrays& p) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < p.pairs; k += block) {
    std::uint32_t all = 0;
    for (std::size_t from = 0; from < block; from += width) {
      const WideArms one = load_arms(p.arms, p.arm_i + k + from), two = load_arms(p.arms, p.arm_j + k + from);
      const Lanes reach = one.radius + two.radius;
      const ClosestPoints<Lanes> c = closest_points(one.axis, two.axis);
      const Mask touching = c.distance2 < reach * reach;
      const std::uint32_t bits = lane_bits(touching);
      hn::CompressBlendedStore(c.s.v, touching.m, Tag(), p.s + count);
      hn::CompressBlendedStore(c.t.v, touching.m, Tag(), p.t + count);
      for (std::uint32_t l = 0; l < width; ++l) {  // writes ahead, keeps what touches
        p.pair[count] = static_cast<std::uint32_t>(k + from) + l;
        count += bits >> l & 1;
      }
      all |= bits << from;
    }
    p.touching[k / block] = static_cast<std::uint8_t>(all);
  }
  return count;
}

/// Indices of `width` contacts; those beyond the last repeat it.
struct Batch {
  alignas(64) double mbar[width];
  alignas(64) double s[width];
  alignas(64) double t[width];
  std::uint32_t pair[width], i[width], j[width], arm_i[width], arm_j[width];
};

JAM_INLINE void fill(Batch& b, const PressArrays& p, std::size_t from, std::size_t count) {
  for (std::size_t l = 0; l < width; ++l) {
    const std::size_t c = from + (l < count ? l : count - 1), k = p.pair[c];
    b.pair[l] = p.pair[c];
    b.i[l] = p.i[k], b.j[l] = p.j[k], b.arm_i[l] = p.arm_i[k], b.arm_j[l] = p.arm_j[k];
    b.mbar[l] = p.mbar[k], b.s[l] = p.s[c], b.t[l] = p.t[c];
  }
}

JAM_INLINE Vec<3, Lanes> velocity_at(const double* rows, const std::uint32_t* index, const Vec<3, Lanes>& lever) {
  return vector_of(load_rows(rows + R::velocity, index, R::stride)) +
         cross(vector_of(load_rows(rows + R::spin, index, R::stride)), lever);
}

template <NormalLaw law, bool friction, ParallelRule parallel>
inline void press_loop(const PressArrays& p) {
  const PairLaw<Lanes> c = p.rule->law.as<Lanes>();
  const Lanes sine2(p.rule->parallel_sine2), dt(p.rule->dt), zero(0.0);
  Batch b;
  for (std::size_t from = 0; from < p.contacts; from += width) {
    const std::size_t count = p.contacts - from < width ? p.contacts - from : width;
    fill(b, p, from, count);
    const Mask real = first_lanes(static_cast<int>(count));
    const WideArms one = load_arms(p.arms, b.arm_i), two = load_arms(p.arms, b.arm_j);
    const ArmTouch<Lanes> t =
        touch_arms<parallel>(one.axis, one.radius, two.axis, two.radius, Lanes::load(b.s), Lanes::load(b.t), sine2);
    const Vec<3, Lanes> lever_i = t.point - vector_of(load_rows(p.rows, b.i, R::stride)),
                        lever_j = t.point - vector_of(load_rows(p.rows, b.j, R::stride));
    const Vec<3, Lanes> v = velocity_at(p.rows, b.i, lever_i) - velocity_at(p.rows, b.j, lever_j);
    Vec<3, Lanes> spring{zero, zero, zero};
    if constexpr (friction) spring = vector_of(load_rows(p.springs, b.pair, 4));
    const auto f = touch<3, law, friction>(c, t.normal, t.overlap, Lanes::load(b.mbar), v,
                                           Vec<3, Lanes>{zero, zero, zero}, spring, dt);
    double* damped = p.tally->damped + from % block;
    double* rubbed = p.tally->rubbed + from % block;
    double* excess = p.tally->excess + from % block;
    (Lanes::load(damped) + select_or_zero(real, f.damped)).store(damped);
    (Lanes::load(rubbed) + select_or_zero(real, f.rubbed)).store(rubbed);
    larger(Lanes::load(excess), t.overlap - smaller(one.radius, two.radius)).store(excess);

    const Vec<3, Lanes> force = (-f.normal) * t.normal + f.tangential;
    const Vec<3, Lanes> torque_i = cross(lever_i, force), torque_j = cross(lever_j, force);
    const Turned forces = turned({force[0], force[1], force[2], zero});
    const Turned torques_i = turned({torque_i[0], torque_i[1], torque_i[2], zero});
    const Turned torques_j = turned({torque_j[0], torque_j[1], torque_j[2], zero});
    const Turned back = -forces, torques_back = -torques_j;
    for (std::size_t l = 0; l < count; ++l) {
      add_two_to<Tag>(p.forces + R::force_stride * b.i[l], forces, torques_i, l);
      add_two_to<Tag>(p.forces + R::force_stride * b.j[l], back, torques_back, l);
    }
    if constexpr (friction) {
      const Rows springs = to_rows({spring[0], spring[1], spring[2], zero});
      for (std::size_t l = 0; l < count; ++l) hn::Store(springs.row[l], Tag4(), p.springs + 4 * b.pair[l]);
    }
  }
}

inline void press(const PressArrays& p) {
  with_law(p.rule->kind, [&]<NormalLaw law>() {
    with_rule(*p.rule, [&]<bool friction, ParallelRule parallel>() { press_loop<law, friction, parallel>(p); });
  });
}

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
