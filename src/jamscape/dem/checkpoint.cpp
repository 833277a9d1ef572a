// The state of an engine as named arrays, and back.
#include <algorithm>
#include <string>
#include <type_traits>

#include "jamscape/base/error.hpp"
#include "jamscape/dem/engine.hpp"

namespace jam {
namespace {

constexpr std::int64_t layout_version = 2;

template <class Array>
std::vector<double> reals(const Array& a) {
  return {std::begin(a), std::end(a)};
}
template <class Array>
std::vector<std::int64_t> integers(const Array& a) {
  std::vector<std::int64_t> out;
  for (const auto n : a) out.push_back(static_cast<std::int64_t>(n));
  return out;
}

template <class T>
const T& fetch(const Archive& archive, const std::string& name) {
  if (const T* entry = find_entry<T>(archive, name)) return *entry;
  throw data_error("the checkpoint lacks '" + name + "'", {}, "delete it; the task then starts from its beginning");
}

template <class Array>
void take(const Archive& archive, const std::string& name, Array& to, bool same_size) {
  using Stored = std::conditional_t<std::is_floating_point_v<typename Array::value_type>, double, std::int64_t>;
  const auto& from = fetch<std::vector<Stored>>(archive, name);
  if (same_size && from.size() != to.size())
    throw data_error("the checkpoint is of another system: '" + name + "' has " + std::to_string(from.size()) +
                     " entries instead of " + std::to_string(to.size()));
  if constexpr (requires { to.resize(from.size()); }) to.resize(from.size());
  for (std::size_t k = 0; k < from.size(); ++k) to[k] = static_cast<typename Array::value_type>(from[k]);
}

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

}  // namespace

template <int D>
void Engine<D>::save(Archive& out) const {
  out["engine/rows"] = reals(bodies_.rows);
  out["engine/derivatives"] = reals(bodies_.derivatives);
  out["engine/inverse"] = as_rows<D>(bodies_);
  out["engine/id"] = integers(bodies_.id);
  out["engine/mass"] = reals(bodies_.mass);
  out["engine/species"] = integers(bodies_.species);
  out["engine/pair_start"] = integers(pairs_.start);
  out["engine/pair_i"] = integers(pairs_.i);
  out["engine/pair_j"] = integers(pairs_.j);
  out["engine/pair_shift"] = integers(pairs_.shift);
  out["engine/pair_mbar"] = reals(pairs_.mbar);
  out["engine/pair_spring"] = reals(pairs_.springs);
  out["engine/plane_grain"] = integers(plane_grain_);
  out["engine/plane_wall"] = integers(plane_wall_);
  std::vector<double> plane_spring, wall_position, wall_velocity;
  for (const auto& s : plane_spring_)
    if constexpr (D == 2)
      plane_spring.push_back(s);
    else
      plane_spring.insert(plane_spring.end(), s.c, s.c + 3);
  for (const auto& wall : walls_) {
    wall_position.push_back(wall.position);
    wall_velocity.push_back(wall.velocity);
  }
  out["engine/plane_spring"] = plane_spring;
  out["engine/wall_position"] = wall_position;
  out["engine/wall_velocity"] = wall_velocity;
  out["engine/box"] = reals(box_.length);
  out["engine/scalars"] =
      std::vector<double>{box_speed_, skin_, moved_, damped_, rubbed_, wall_work_, gravity_work_, dt_};
  out["engine/deepest"] = reals(tally_.deepest);
  out["engine/counters"] =
      std::vector<std::int64_t>{layout_version, D, static_cast<std::int64_t>(scheme_), step_, lists_, stale_};
}

template <int D>
void Engine<D>::load(const Archive& in) {
  const auto& counters = fetch<std::vector<std::int64_t>>(in, "engine/counters");
  if (counters.size() != 6 || counters[0] != layout_version || counters[1] != D ||
      counters[2] != static_cast<std::int64_t>(scheme_))
    throw data_error("the checkpoint is of another version or another kind of system", {},
                     "delete it; the task then starts from its beginning");
  take(in, "engine/rows", bodies_.rows, true);
  take(in, "engine/derivatives", bodies_.derivatives, true);
  std::vector<double> inverse(bodies_.forces.size());
  take(in, "engine/inverse", inverse, true);
  for (std::size_t k = 0; k < bodies_.count(); ++k) {
    bodies_.inverse[2 * k] = inverse[k * Row<D>::force_stride];
    bodies_.inverse[2 * k + 1] = inverse[k * Row<D>::force_stride + (D == 2 ? 2 : 4)];
  }
  take(in, "engine/id", bodies_.id, true);
  take(in, "engine/mass", bodies_.mass, true);
  take(in, "engine/species", bodies_.species, true);
  take(in, "engine/pair_start", pairs_.start, true);
  take(in, "engine/pair_i", pairs_.i, false);
  take(in, "engine/pair_j", pairs_.j, false);
  take(in, "engine/pair_shift", pairs_.shift, false);
  take(in, "engine/pair_mbar", pairs_.mbar, false);
  take(in, "engine/pair_spring", pairs_.springs, false);
  const std::size_t pairs = pairs_.i.size();
  if (pairs_.j.size() != pairs || pairs_.shift.size() != pairs || pairs_.mbar.size() != pairs ||
      pairs_.start.back() != pairs || pairs_.springs.size() != pairs * PairList<D>::spring_size)
    throw data_error("the checkpoint's pair list is inconsistent", {},
                     "delete it; the task then starts from its beginning");
  take(in, "engine/plane_grain", plane_grain_, false);
  take(in, "engine/plane_wall", plane_wall_, false);
  std::vector<double> plane_spring, position(walls_.size()), velocity(walls_.size()), scalars(8);
  take(in, "engine/plane_spring", plane_spring, false);
  plane_spring_.resize(plane_grain_.size());
  for (std::size_t q = 0; q < plane_spring_.size(); ++q)
    if constexpr (D == 2)
      plane_spring_[q] = plane_spring.at(q);
    else
      plane_spring_[q] = {plane_spring.at(3 * q), plane_spring.at(3 * q + 1), plane_spring.at(3 * q + 2)};
  take(in, "engine/wall_position", position, true);
  take(in, "engine/wall_velocity", velocity, true);
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    walls_[w].position = position[w];
    walls_[w].velocity = velocity[w];
  }
  take(in, "engine/box", box_.length, true);
  shifts_ = image_shifts<D>(box_);
  take(in, "engine/scalars", scalars, true);
  box_speed_ = scalars[0], skin_ = scalars[1], moved_ = scalars[2];
  damped_ = scalars[3], rubbed_ = scalars[4], wall_work_ = scalars[5], gravity_work_ = scalars[6];
  const auto& deepest = fetch<std::vector<double>>(in, "engine/deepest");
  for (std::size_t k = 0; k < block && k < deepest.size(); ++k) tally_.deepest[k] = deepest[k];
  watch_until_ = -1;  // near pairs are looked through anew
  step_ = counters[3], lists_ = counters[4], stale_ = counters[5] != 0;
  std::fill(bodies_.forces.begin(), bodies_.forces.end(), 0.0);
  std::fill(wall_force_.begin(), wall_force_.end(), Vec<D>{});
}

template void Engine<2>::save(Archive&) const;
template void Engine<3>::save(Archive&) const;
template void Engine<2>::load(const Archive&);
template void Engine<3>::load(const Archive&);

}  // namespace jam
