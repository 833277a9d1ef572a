// The contact loop of clusters for vectors of four or eight arm pairs: of all listed ones where most of them touch, or
// of those collected. Forces are transposed in registers and added row by row in the order of the plain loop. Included
// by one file per vector width.
#pragma once

#include <bit>

#include "jamscape/dem/cluster_contact.hpp"
#include "jamscape/dem/cluster_kernel.hpp"
#include "jamscape/dem/cluster_rows_wide.hpp"

namespace jam::HWY_NAMESPACE::clusters {

/// Energies of contacts on their way into the tally. Many are kept: what has just been stored in two parts cannot be
/// loaded in one without waiting.
struct Booked {
  static constexpr std::size_t room = 32 * block;
  alignas(64) double damped[room + block], rubbed[room + block];
  std::size_t count = 0;

  JAM_INLINE void add(Mask touching, std::uint32_t bits, Lanes more_damped, Lanes more_rubbed, ClusterTally& tally) {
    store_chosen(more_damped, touching, damped + count);
    store_chosen(more_rubbed, touching, rubbed + count);
    count += static_cast<std::size_t>(std::popcount(bits));
    if (count < room) return;
    empty(room, tally);
    for (std::size_t l = 0; l < block; l += width) {
      Lanes::load(damped + room + l).store(damped + l);
      Lanes::load(rubbed + room + l).store(rubbed + l);
    }
    count -= room;
  }
  /// Hands over the first `number`.
  void empty(std::size_t number, ClusterTally& tally) const {
    for (std::size_t l = 0; l < number; l += width) {
      const Mask real = first_lanes(static_cast<int>(number - l < width ? number - l : width));
      double *to_damped = tally.damped + l % block, *to_rubbed = tally.rubbed + l % block;
      (Lanes::load(to_damped) + select_or_zero(real, Lanes::load(damped + l))).store(to_damped);
      (Lanes::load(to_rubbed) + select_or_zero(real, Lanes::load(rubbed + l))).store(to_rubbed);
    }
  }
};

/// Where the pairs of a vector have their data.
struct ArmPairPointers {
  const std::uint32_t *i, *j, *arm_i, *arm_j;
  const double* mbar;
  const std::uint32_t* pair;  ///< of collected ones
};

/// Indices of `width` collected pairs; those beyond the last repeat it.
struct Batch {
  alignas(64) double mbar[width];
  alignas(32) std::uint32_t pair[width], i[width], j[width], arm_i[width], arm_j[width];

  JAM_INLINE void fill(const PressArrays& p, std::size_t from) {
    constexpr hn::CappedTag<std::uint32_t, width> d;
    constexpr hn::RebindToSigned<decltype(d)> index;
    if (p.contacts - from < width) {
      for (std::size_t l = 0; l < width; ++l) pair[l] = p.pair[from + l < p.contacts ? from + l : p.contacts - 1];
    } else {
      hn::Store(hn::LoadU(d, p.pair + from), d, pair);
    }
    const auto k = hn::BitCast(index, hn::Load(d, pair));
    hn::Store(hn::GatherIndex(d, p.i, k), d, i);
    hn::Store(hn::GatherIndex(d, p.j, k), d, j);
    hn::Store(hn::GatherIndex(d, p.arm_i, k), d, arm_i);
    hn::Store(hn::GatherIndex(d, p.arm_j, k), d, arm_j);
    hn::Store(hn::GatherIndex(Tag(), p.mbar, hn::PromoteTo(hn::RebindToSigned<Tag>(), k)), Tag(), mbar);
  }
};

// What a stage hands to the next. `bits`, as `touching`: the pairs that touch.
struct Met {
  ArmApproach<Lanes> arms;
  Mask touching;
  std::uint32_t bits = 0;
};
struct Moving {
  ArmTouch<Lanes> touch;
  Vec<3, Lanes> lever_i, lever_j, v;
  Mask touching;
  std::uint32_t bits = 0;
};
struct Pushed {
  Vec<3, Lanes> force, torque_i, torque_j;  ///< 0 where nothing touches
  std::uint32_t bits = 0;
};

JAM_INLINE Vec<3, Lanes> velocity_at(const double* rows, const std::uint32_t* index, const Vec<3, Lanes>& lever) {
  return vector_of(load_rows(rows + R::velocity, index, R::stride)) +
         cross(vector_of(load_rows(rows + R::spin, index, R::stride)), lever);
}

JAM_INLINE void move(const double* rows, const ArmPairPointers& at, const Met& met, Moving& m) {
  touch_of(met.arms, m.touch);
  m.lever_i = m.touch.point - vector_of(load_rows(rows, at.i, R::stride));
  m.lever_j = m.touch.point - vector_of(load_rows(rows, at.j, R::stride));
  m.v = velocity_at(rows, at.i, m.lever_i) - velocity_at(rows, at.j, m.lever_j);
  m.touching = met.touching;
}

/// The law; springs stand in the rows of four that `row` gives, of those pairs that touch or are `listed`.
template <NormalLaw law, bool friction, bool listed, class Row>
JAM_INLINE void push_of(const PairLaw<Lanes>& c, Lanes dt, const double* mbar, const Row& row, const Moving& m,
                        Booked& booked, ClusterTally& tally, Pushed& out) {
  const Lanes zero(0.0);
  const Vec<3, Lanes> none{zero, zero, zero};
  Vec<3, Lanes> spring = none;
  if constexpr (friction) spring = vector_of(columns(load_turned(row)));
  const Vec<3, Lanes> before = spring;
  const auto f = touch<3, law, friction>(c, m.touch.normal, m.touch.overlap, Lanes::load(mbar), m.v, none, spring, dt);
  booked.add(m.touching, m.bits, f.damped, f.rubbed, tally);
  if constexpr (friction) {
    Columns kept{{zero, zero, zero, zero}};
    for (int e = 0; e < 3; ++e) kept.c[e] = select(m.touching, spring[e], before[e]);
    const Rows springs = to_rows(kept);
    for (std::size_t l = 0; l < width; ++l)
      if (listed || m.bits >> l & 1) hn::Store(springs.row[l], Tag4(), row(l));
  }
  for (int e = 0; e < 3; ++e)
    out.force[e] = select_or_zero(m.touching, -f.normal * m.touch.normal[e] + f.tangential[e]);
  out.torque_i = cross(m.lever_i, out.force), out.torque_j = cross(m.lever_j, out.force);
}

JAM_INLINE void add_push(double* forces, const ArmPairPointers& at, const Pushed& f) {
  const Lanes zero(0.0);
  const Turned force = turned({f.force[0], f.force[1], f.force[2], zero}),
               on_i = turned({f.torque_i[0], f.torque_i[1], f.torque_i[2], zero}),
               on_j = turned({f.torque_j[0], f.torque_j[1], f.torque_j[2], zero});
  for (std::size_t l = 0; l < width; ++l) {
    add_two_to(forces + R::force_stride * at.i[l], force, on_i, l);
    subtract_two_from(forces + R::force_stride * at.j[l], force, on_j, l);
  }
}

/// Stages: where arms touch, relative motion, law, sums. In each turn four vectors go through one of them, the oldest
/// first, so that none waits for another and what is handed on has one place. `listed`: of all listed pairs, those that
/// do not touch being masked; otherwise of the collected ones. Returns how many touch.
template <NormalLaw law, bool friction, ParallelRule parallel, bool listed>
inline std::size_t press_loop(const PressArrays& arrays) {
  const PressArrays p = arrays;  // pointers that no store can change
  const std::size_t end = listed ? p.pairs : (p.contacts + width - 1) / width * width;
  const PairLaw<Lanes> c = p.rule->law.as<Lanes>();
  const Lanes sine2(p.rule->parallel_sine2), dt(p.rule->dt);
  Lanes excess(-1.0);
  Batch batches[4];
  Met met;
  Moving moving;
  Pushed pushed;
  Booked booked;
  std::size_t touching = 0;
  const auto where = [&](std::size_t k) -> ArmPairPointers {
    if constexpr (listed) return {p.i + k, p.j + k, p.arm_i + k, p.arm_j + k, p.mbar + k, nullptr};
    const Batch& b = batches[k / width % 4];
    return {b.i, b.j, b.arm_i, b.arm_j, b.mbar, b.pair};
  };
  for (std::size_t k = 0; k < end + 3 * width; k += width) {
    if (pushed.bits) add_push(p.forces, where(k - 3 * width), pushed);
    pushed.bits = moving.bits;
    if (moving.bits) {
      const std::size_t from = k - 2 * width;
      const ArmPairPointers at = where(from);
      const auto row = [&](std::size_t l) { return p.springs + 4 * (listed ? from + l : at.pair[l]); };
      push_of<law, friction, listed>(c, dt, at.mbar, row, moving, booked, *p.tally, pushed);
    }
    moving.bits = met.bits;
    if (met.bits) {
      move(p.rows, where(k - width), met, moving);
      excess = larger(excess, moving.touch.overlap - smaller(met.arms.r1, met.arms.r2));
    }
    met.bits = 0;
    if (k < end) {
      if constexpr (!listed) batches[k / width % 4].fill(p, k);
      const ArmPairPointers at = where(k);
      const WideArms one = load_arms(p.arms, at.arm_i), two = load_arms(p.arms, at.arm_j);
      approach<parallel>(one.axis, one.radius, two.axis, two.radius, sine2, met.arms);
      met.touching = met.arms.touching();
      met.bits = lane_bits(met.touching);
      if constexpr (listed) {
        const std::size_t shift = k % block;
        std::uint8_t& bits = p.touching[k / block];
        bits = static_cast<std::uint8_t>((shift ? bits : 0) | met.bits << shift);
        touching += static_cast<std::size_t>(std::popcount(met.bits));
      } else if (p.contacts - k < width) {
        met.bits &= (1u << (p.contacts - k)) - 1, met.touching = lanes_of(static_cast<std::uint8_t>(met.bits));
      }
    }
  }
  booked.empty(booked.count, *p.tally);
  double* most = p.tally->excess;
  larger(Lanes::load(most), excess).store(most);
  return touching;
}

inline void press(const PressArrays& p) {
  with_rule(*p.rule, [&]<NormalLaw law, bool friction, ParallelRule parallel>() {
    press_loop<law, friction, parallel, false>(p);
  });
}

inline std::size_t press_listed(const PressArrays& p) {
  std::size_t touching = 0;
  with_rule(*p.rule, [&]<NormalLaw law, bool friction, ParallelRule parallel>() {
    touching = press_loop<law, friction, parallel, true>(p);
  });
  return touching;
}

}  // namespace jam::HWY_NAMESPACE::clusters
