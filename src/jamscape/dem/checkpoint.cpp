// The state of an engine as named arrays, and back.
#include <algorithm>
#include <string>

#include "jamscape/dem/engine.hpp"
#include "jamscape/dem/stored_arrays.hpp"

namespace jam {
namespace {

constexpr std::int64_t layout_version = 2;

/// Inverse inertias laid out like forces, as checkpoints hold them.
template <int D>
std::vector<double> as_rows(const Bodies<D>& bodies) {
  std::vector<double> out(bodies.forces.size(), 0.0);
  for (std::size_t k = 0; k < bodies.count(); ++k) {
    double* row = out.data() + k * Row<D>::force_stride;
    for (std::size_t c = 0; c < D; ++c) row[c] = bodies.inverse_mass(k);
    for (std::size_t c = 0; c < (D == 2 ? 1 : 3); ++c) row[(D == 2 ? 2 : 4) + c] = bodies.inverse_inertia(k);
  }
  return out;
}

/// Where the groups' runs begin; which parts they join and in which round only if there is more than one part.
template <int D>
void save_groups(const PairList<D>& pairs, Archive& out) {
  std::vector<std::int64_t> start{0}, a, b;
  for (const PairGroup& g : pairs.groups) {
    start.insert(start.end(), g.start.begin() + 1, g.start.end());
    a.push_back(g.a), b.push_back(g.b);
  }
  out["engine/pair_start"] = start;
  if (pairs.groups.size() == 1) return;
  out["engine/group_a"] = a;
  out["engine/group_b"] = b;
  out["engine/first_of_round"] = integers(pairs.first_of_round);
}

template <int D>
void load_groups(const Archive& in, PairList<D>& pairs, const Parts& parts) {
  std::vector<std::size_t> start;
  take(in, "engine/pair_start", start);
  std::vector<std::uint32_t> a(1, 0), b(1, 0);
  pairs.first_of_round = {0};
  if (parts.size() > 1) {
    take(in, "engine/group_a", a);
    take(in, "engine/group_b", b);
    take(in, "engine/first_of_round", pairs.first_of_round);
  }
  bool sound = start.size() == pair_runs * a.size() + 1 && b.size() == a.size() && !a.empty() &&
               !pairs.first_of_round.empty() && pairs.first_of_round.back() + parts.stretches() == a.size() &&
               std::is_sorted(pairs.first_of_round.begin(), pairs.first_of_round.end());
  for (std::size_t g = 0; sound && g < a.size(); ++g) sound = a[g] < parts.with_grains() && b[g] < parts.size();
  if (!sound) refuse_checkpoint("'s pair list is inconsistent");
  pairs.groups.assign(a.size(), {});
  for (std::size_t g = 0; g < a.size(); ++g) {
    pairs.groups[g] = {a[g], b[g], {}};
    std::copy_n(start.begin() + static_cast<std::ptrdiff_t>(g * pair_runs), pair_runs + 1,
                pairs.groups[g].start.begin());
  }
}

}  // namespace

template <int D>
void Engine<D>::save(Archive& out) const {
  out["engine/rows"] = reals(bodies_.rows);
  out["engine/derivatives"] = reals(bodies_.derivatives);
  out["engine/inverse"] = as_rows<D>(bodies_);
  out["engine/id"] = integers(bodies_.id);
  out["engine/mass"] = reals(bodies_.mass);
  out["engine/species"] = integers(bodies_.species);
  save_groups(pairs_, out);
  out["engine/pair_i"] = integers(pairs_.i);
  out["engine/pair_j"] = integers(pairs_.j);
  out["engine/pair_shift"] = integers(pairs_.shift);
  out["engine/pair_mbar"] = reals(pairs_.mbar);
  out["engine/pair_spring"] = reals(pairs_.springs);
  out["engine/plane_grain"] = integers(plane_grain_);
  out["engine/plane_wall"] = integers(plane_wall_);
  std::vector<double> wall_position, wall_velocity;
  for (const auto& wall : walls_) {
    wall_position.push_back(wall.position);
    wall_velocity.push_back(wall.velocity);
  }
  if constexpr (D == 2)
    out["engine/plane_spring"] = plane_spring_;
  else
    out["engine/plane_spring"] = components(plane_spring_);
  out["engine/wall_position"] = wall_position;
  out["engine/wall_velocity"] = wall_velocity;
  out["engine/box"] = reals(box_.length);
  out["engine/scalars"] = std::vector<double>{
      box_speed_, skin_, moved_, booked_.damped, booked_.rubbed, booked_.wall_work, booked_.gravity_work, dt_};
  if (summed_) {  // springs and ledger have had this step
    out["engine/forces"] = reals(bodies_.forces);
    out["engine/wall_force"] = components(wall_force_);
  }
  if (fastest_plane() > 0 || planes_moved_ > 0) out["engine/planes_moved"] = std::vector<double>{planes_moved_};
  Tally tally{};
  for (const Sums& sums : sums_)
    for (std::size_t k = 0; k < block; ++k) tally.deepest[k] = larger(tally.deepest[k], sums.tally.deepest[k]);
  out["engine/deepest"] = reals(tally.deepest);
  out["engine/counters"] =
      std::vector<std::int64_t>{layout_version, D, static_cast<std::int64_t>(scheme_), step_, lists_, stale_};
}

template <int D>
void Engine<D>::load(const Archive& in) {
  const auto& counters = fetch<std::vector<std::int64_t>>(in, "engine/counters");
  if (counters.size() != 6 || counters[0] != layout_version || counters[1] != D ||
      counters[2] != static_cast<std::int64_t>(scheme_))
    refuse_checkpoint(" is of another version or another kind of system");
  take(in, "engine/rows", bodies_.rows, bodies_.rows.size());
  take(in, "engine/derivatives", bodies_.derivatives, bodies_.derivatives.size());
  std::fill(bodies_.calm.begin(), bodies_.calm.end(), std::uint8_t{0});
  std::vector<double> inverse(bodies_.forces.size());
  take(in, "engine/inverse", inverse, inverse.size());
  for (std::size_t k = 0; k < bodies_.count(); ++k) {
    bodies_.inverse[2 * k] = inverse[k * Row<D>::force_stride];
    bodies_.inverse[2 * k + 1] = inverse[k * Row<D>::force_stride + (D == 2 ? 2 : 4)];
  }
  take(in, "engine/id", bodies_.id, bodies_.id.size());
  take(in, "engine/mass", bodies_.mass, bodies_.mass.size());
  take(in, "engine/species", bodies_.species, bodies_.species.size());
  load_groups(in, pairs_, parts_);
  take(in, "engine/pair_i", pairs_.i);
  take(in, "engine/pair_j", pairs_.j);
  take(in, "engine/pair_shift", pairs_.shift);
  take(in, "engine/pair_mbar", pairs_.mbar);
  take(in, "engine/pair_spring", pairs_.springs);
  const std::size_t pairs = pairs_.i.size();
  if (pairs_.j.size() != pairs || pairs_.shift.size() != pairs || pairs_.mbar.size() != pairs ||
      pairs_.groups.back().start.back() != pairs || pairs_.springs.size() != pairs * PairList<D>::spring_size)
    refuse_checkpoint("'s pair list is inconsistent");
  take(in, "engine/plane_grain", plane_grain_);
  take(in, "engine/plane_wall", plane_wall_);
  take(in, "engine/plane_spring", plane_spring_, plane_grain_.size());
  first_plane_.assign(1, 0);  // they stand by stretch
  for (std::size_t q = 0, stretch = 0; stretch < parts_.stretches(); ++stretch) {
    while (q < plane_grain_.size() && parts_.stretch_of(plane_grain_[q]) == stretch) ++q;
    first_plane_.push_back(q);
  }
  if (first_plane_.back() != plane_grain_.size() || plane_wall_.size() != plane_grain_.size())
    refuse_checkpoint("'s plane contacts are inconsistent");
  std::vector<double> position(walls_.size()), velocity(walls_.size()), scalars(8);
  take(in, "engine/wall_position", position, position.size());
  take(in, "engine/wall_velocity", velocity, velocity.size());
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    walls_[w].position = position[w];
    walls_[w].velocity = velocity[w];
  }
  take(in, "engine/box", box_.length, box_.length.size());
  shifts_ = image_shifts<D>(box_);
  take(in, "engine/scalars", scalars, scalars.size());
  box_speed_ = scalars[0], skin_ = scalars[1], moved_ = scalars[2];
  booked_.damped = scalars[3], booked_.rubbed = scalars[4], booked_.wall_work = scalars[5],
  booked_.gravity_work = scalars[6];
  const auto* planes = find_entry<std::vector<double>>(in, "engine/planes_moved");
  planes_moved_ = planes && planes->size() == 1 ? (*planes)[0] : 0;
  const auto& deepest = fetch<std::vector<double>>(in, "engine/deepest");
  for (Sums& sums : sums_) sums.tally = {};
  for (std::size_t k = 0; k < block && k < deepest.size(); ++k) sums_[0].tally.deepest[k] = deepest[k];
  watch_until_ = -1;  // near pairs are looked through anew
  step_ = counters[3], lists_ = counters[4], stale_ = counters[5] != 0;
  if (!planes && fastest_plane() > 0) stale_ = true;  // of a version that did not count how far planes move
  summed_ = in.contains("engine/forces");
  std::fill(bodies_.forces.begin(), bodies_.forces.end(), 0.0);
  std::fill(wall_force_.begin(), wall_force_.end(), Vec<D>{});
  if (!summed_) return;
  take(in, "engine/forces", bodies_.forces, bodies_.forces.size());
  take(in, "engine/wall_force", wall_force_, walls_.size());
  for (Sums& sums : sums_) sums.fastest = {};
  few_pushed_ = false;  // leaves out nothing: no bit depends on it
}

template void Engine<2>::save(Archive&) const;
template void Engine<3>::save(Archive&) const;
template void Engine<2>::load(const Archive&);
template void Engine<3>::load(const Archive&);

}  // namespace jam
