// A step: sums of forces, motion, and what they tell about the next one.
#include <algorithm>
#include <cmath>

#include "jamscape/dem/engine.hpp"
#include "jamscape/dem/slots.hpp"

namespace jam {
template <int D>
void Engine<D>::compute_forces() {
  if (summed_) return;
  begin_sums();
  team_->run(parts_.with_grains(), [&](std::size_t part) { sum_own(part, false); });
  add_up();
  summed_ = true;
}

template <int D>
void Engine<D>::run(std::int64_t n) {
  for (; n > 0; --n) make_step();
}

template <int D>
void Engine<D>::make_step() {
  if (summed_) {
    team_->run(parts_.with_grains(), [&](std::size_t part) {
      for (auto [stretch, end] = parts_.stretches_of(part); stretch < end; ++stretch) move_bodies(part, stretch);
    });
  } else {
    begin_sums();
    team_->run(parts_.with_grains(), [&](std::size_t part) { sum_own(part, true); });
    add_up();
  }
  end_step();
  summed_ = false;
}

/// Whatever comes before the pairs within parts.
template <int D>
void Engine<D>::begin_sums() {
  if (stale_) relist();
  if (!(moved_ < watch_until_)) watch_near();
  if (D == 3 && spring_turn_ == SpringTurn::twirled) twirl_springs();
  few_pushed_ = pairs_.touching() < bodies_.grains / 2;
  for (Sums& sums : sums_) {
    for (auto* slots : {&sums.tally.damped, &sums.tally.rubbed, &sums.tally.virial})
      std::fill(std::begin(*slots), std::end(*slots), 0.0);
    std::fill(sums.wall_force.begin(), sums.wall_force.end(), Vec<D>{});
    sums.gravity_power = 0;
    sums.fastest = {};
  }
  for (std::size_t round = 0; round + 1 < pairs_.first_of_round.size(); ++round) {
    const std::size_t first = pairs_.first_of_round[round];
    team_->run(pairs_.first_of_round[round + 1] - first, [&](std::size_t g) { sum_pairs(first + g); });
  }
}

template <int D>
void Engine<D>::sum_pairs(std::size_t group) {
  PairArrays p = pair_arrays(pairs_.groups[group].a);
  for (std::size_t run = 0; run < pair_runs; ++run) {
    const PairRange range = range_of(group, run);
    p.shift = run / 2 == static_cast<std::size_t>(PairKind::across) ? pairs_.shift.data() : nullptr;
    if (range.begin < range.end) kernels_->template pairs<D>()(p, range);
  }
}

/// The forces within a part, stretch by stretch, each of which may then be moved.
template <int D>
void Engine<D>::sum_own(std::size_t part, bool move) {
  const bool falling = dot(gravity_, gravity_) > 0;
  for (auto [stretch, end] = parts_.stretches_of(part); stretch < end; ++stretch) {
    sum_pairs(pairs_.first_of_round.back() + stretch);
    touch_planes(part, stretch);
    if (falling) pull_down(part, stretch);
    if (stretch + 1 == parts_.stretches()) collect_beads();
    if (move) move_bodies(part, stretch);
  }
}

template <int D>
void Engine<D>::move_bodies(std::size_t part, std::size_t stretch) {
  const auto [begin, end] = parts_.bodies_of_stretch(stretch);
  BodyArrays b{bodies_.rows.data() + begin * Row<D>::stride,
               bodies_.forces.data() + begin * Row<D>::force_stride,
               bodies_.inverse.data() + 2 * begin,
               bodies_.derivatives.data() + (bodies_.derivatives.empty() ? 0 : begin * 12 * Row<D>::motions),
               bodies_.calm.data() + (bodies_.calm.empty() ? 0 : begin),
               end - begin,
               dt_,
               few_pushed_,
               {}};
  (scheme_ == Scheme::verlet ? kernels_->template verlet<D>() : kernels_->template gear<D>())(b);
  std::array<double, 4>& fastest = sums_[part].fastest;
  for (std::size_t c = 0; c < fastest.size(); ++c) fastest[c] = larger(fastest[c], b.fastest[c]);
}

/// Books what the parts have summed, in their order.
template <int D>
void Engine<D>::add_up() {
  double damped = 0, rubbed = 0, virial = 0, gravity_power = 0;
  for (const Sums& sums : sums_) {
    damped += sum_of(sums.tally.damped);
    rubbed += sum_of(sums.tally.rubbed);
    virial += sum_of(sums.tally.virial);
    gravity_power += sums.gravity_power;
    for (std::size_t w = 0; w < walls_.size(); ++w) wall_force_[w] += sums.wall_force[w];
  }
  booked_.gravity_work += gravity_power * dt_;
  for (const EngineWall<D>& wall : walls_)
    if (wall.kind == WallKind::plane)
      booked_.wall_work -=
          wall_force_[static_cast<std::size_t>(&wall - walls_.data())][wall.axis] * wall.velocity * dt_;
  booked_.damped += damped * dt_;
  booked_.rubbed += rubbed;
  if (box_speed_ != 0) booked_.wall_work += shrinking() * dt_ * virial;
}

/// Moves the walls, and sees how far bodies may have come.
template <int D>
void Engine<D>::end_step() {
  std::array<double, 4> fastest{};
  for (const Sums& sums : sums_)
    for (std::size_t c = 0; c < fastest.size(); ++c) fastest[c] = larger(fastest[c], sums.fastest[c]);
  double speed2 = fastest[0] + fastest[1];  // in two dimensions the third component is the spin
  if constexpr (D == 3) speed2 += fastest[2];
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    walls_[w].position += walls_[w].velocity * dt_;
    wall_force_[w] = Vec<D>{};
  }
  if (box_speed_ != 0) shrink_box();
  // Gear moves by v dt + a dt^2/2 + ...: the larger of the speeds before and after, and a little more, bounds it
  moved_ += 1.02 * std::sqrt(speed2) * dt_;
  planes_moved_ += 1.02 * fastest_plane() * dt_;
  closing_ = closing_in_a_step(speed2);
  stale_ = stale_ || !(2 * moved_ < skin_) || !(moved_ + planes_moved_ < skin_);
  ++step_;
  check_speed(std::sqrt(speed2));
  if (step_ % 64 == 0) {
    double deepest = 0;
    for (Sums& sums : sums_)
      for (double& d : sums.tally.deepest) deepest = std::max(deepest, d), d = 0;
    if (deepest > deepest_overlap * smallest_ || step_ % 1024 == 0) check();
  }
}

/// How much nearer two bodies of at most that speed come in a step.
template <int D>
double Engine<D>::closing_in_a_step(double speed2) const {
  return (2 * std::sqrt(speed2) + 2 * largest_ * std::abs(shrinking())) * dt_;
}

/// Positions are scaled with the box, velocities are those beside that motion: the velocity of a place of the packing
/// is v - shrinking() (x - lo).
template <int D>
void Engine<D>::shrink_box() {
  double strain = 0;
  for (std::size_t c = 0; c < D; ++c) {
    const double length = box_.length[c] - 2 * box_speed_ * dt_, factor = length / box_.length[c];
    team_->run(parts_.with_grains(), [&](std::size_t part) {
      for (auto [k, end] = parts_.grains(part); k < end; ++k) {
        double& x = bodies_.row(k)[c];
        x = box_.lo[c] + (x - box_.lo[c]) * factor;
      }
    });
    box_.length[c] = length;
    strain = std::max(strain, std::abs(1 - factor));
  }
  shifts_ = image_shifts<D>(box_);
  moved_ += strain * (largest_ + skin_ / 2);  // half of what two listed bodies come closer by
}

#define JAM_INSTANTIATE(D)                                        \
  template void Engine<D>::compute_forces();                      \
  template void Engine<D>::run(std::int64_t);                     \
  template void Engine<D>::make_step();                           \
  template void Engine<D>::begin_sums();                          \
  template void Engine<D>::sum_pairs(std::size_t);                \
  template void Engine<D>::sum_own(std::size_t, bool);            \
  template void Engine<D>::move_bodies(std::size_t, std::size_t); \
  template void Engine<D>::add_up();                              \
  template void Engine<D>::end_step();                            \
  template double Engine<D>::closing_in_a_step(double) const;     \
  template void Engine<D>::shrink_box();
JAM_INSTANTIATE(2)
JAM_INSTANTIATE(3)

}  // namespace jam
