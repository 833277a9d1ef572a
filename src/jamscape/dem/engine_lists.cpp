// When lists are made, of which width, and what kernels get of them.
#include <algorithm>
#include <cmath>

#include "jamscape/dem/cell_grid.hpp"
#include "jamscape/dem/engine.hpp"

namespace jam {
namespace {

/// The skin weighs the cost of making lists against that of listed pairs that do not touch. Both are lowest together at
/// sqrt(list_cost * closing), closing = how much nearer two bodies may come in a step, list_cost = the cost of a list
/// over the cost of testing the pairs one more diameter of skin would list (estimated from a profile, not tuned).
/// Bounds in grain diameters.
constexpr double list_cost = 40, thinnest_skin = 0.01, widest_skin = 0.3;
/// Near pairs are looked through for those to watch when these may have changed. Cost of that over the cost of testing
/// them once, as for the skin: the width watched is sqrt(watch_cost * closing * skin).
constexpr double watch_cost = 1;
}  // namespace

template <int D>
PairArrays Engine<D>::pair_arrays(std::size_t part) {
  return {bodies_.rows.data(),
          bodies_.forces.data(),
          pairs_.i.data(),
          pairs_.j.data(),
          pairs_.mbar.data(),
          pairs_.springs.data(),
          nullptr,
          shifts_.data(),
          dt_,
          shrinking(),
          &sums_[part].tally,
          {watch_i_.data(), watch_j_.data(), watch_shift_.data(), watch_pair_.data(), watch_touching_.data()},
          bodies_.nobody(part)};
}

template <int D>
PairRange Engine<D>::range_of(std::size_t group, std::size_t run) const {
  const PairLaw<>& law = static_cast<PairKind>(run / 2) == PairKind::bead ? wall_law_ : grain_law_;
  const auto& start = pairs_.groups[group].start;
  return {start[run], start[run + 1], run % 2 == 1, watched_[group][run], law, kind_, law.mu > 0};
}

template <int D>
void Engine<D>::relist() {
  using R = Row<D>;
  check();
  double speed2 = 0;
  for (std::size_t k = 0; k < bodies_.count(); ++k) {
    double* row = bodies_.row(k);
    double v2 = 0;
    for (std::size_t c = 0; c < D; ++c) {
      v2 += row[R::velocity + c] * row[R::velocity + c];
      if (box_.length[c] > 0 && k < bodies_.grains)
        row[c] -= box_.length[c] * std::floor((row[c] - box_.lo[c]) / box_.length[c]);
    }
    speed2 = std::max(speed2, v2);
  }
  const std::vector<std::uint32_t> old_id = bodies_.id;
  std::vector<Axial<D>> plane_spring(walls_.size() * bodies_.grains, Axial<D>{});
  for (std::size_t q = 0; q < plane_grain_.size(); ++q)
    plane_spring[plane_wall_[q] * bodies_.grains + old_id[plane_grain_[q]]] = plane_spring_[q];

  if (lists_++ % lists_per_order == 0) bodies_.reorder(spatial_order(bodies_));
  const double closing = closing_in_a_step(speed2), fastest = std::max(closing, 2 * fastest_plane() * dt_);
  skin_ = std::clamp(std::sqrt(list_cost * diameter_ * fastest), thinnest_skin * diameter_, widest_skin * diameter_);
  pairs_ = list_pairs<D>(bodies_, box_, skin_, pairs_, old_id, parts_, *kernels_, *team_);

  plane_grain_.clear(), plane_wall_.clear(), plane_spring_.clear();
  first_plane_.assign(1, 0);
  for (std::size_t stretch = 0; stretch < parts_.stretches(); ++stretch) {
    for (std::size_t w = 0; w < walls_.size(); ++w) {
      if (walls_[w].kind != WallKind::plane) continue;
      const double sign = walls_[w].high ? -1.0 : 1.0;
      for (auto [k, end] = parts_.stretch(stretch); k < end; ++k) {
        const double gap = sign * (bodies_.row(k)[walls_[w].axis] - walls_[w].position) - bodies_.radius(k);
        if (gap >= skin_) continue;
        plane_grain_.push_back(static_cast<std::uint32_t>(k));
        plane_wall_.push_back(static_cast<std::uint32_t>(w));
        plane_spring_.push_back(plane_spring[w * bodies_.grains + bodies_.id[k]]);
      }
    }
    first_plane_.push_back(plane_grain_.size());
  }
  moved_ = planes_moved_ = 0;
  watch_until_ = -1;
  closing_ = closing;
  stale_ = false;
}

template <int D>
void Engine<D>::watch_near() {
  const double margin = std::min(skin_, std::max(std::sqrt(watch_cost * closing_ * skin_), 2 * closing_));
  watch_until_ = moved_ + margin / 2;
  if (watch_i_.size() < pairs_.size()) {
    for (auto* a : {&watch_i_, &watch_j_, &watch_shift_, &watch_pair_}) a->resize(pairs_.size());
    watch_touching_.resize(pairs_.size() / block);
  }
  watched_.resize(pairs_.groups.size());
  team_->run(pairs_.groups.size(), [&](std::size_t group) {
    PairArrays p = pair_arrays(pairs_.groups[group].a);
    for (std::size_t run = 1; run < pair_runs; run += 2) {
      p.shift = run / 2 == static_cast<std::size_t>(PairKind::across) ? pairs_.shift.data() : nullptr;
      watched_[group][run] = kernels_->template watch<D>()(p, range_of(group, run), margin);
    }
  });
}

#define JAM_INSTANTIATE(D)                                                \
  template PairArrays Engine<D>::pair_arrays(std::size_t);                \
  template PairRange Engine<D>::range_of(std::size_t, std::size_t) const; \
  template void Engine<D>::relist();                                      \
  template void Engine<D>::watch_near();
JAM_INSTANTIATE(2)
JAM_INSTANTIATE(3)

}  // namespace jam
