#include "jamscape/dem/engine.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "jamscape/base/error.hpp"
#include "jamscape/dem/spin.hpp"

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
/// Grains are put back into spatial order at every so-manieth list.
constexpr std::int64_t lists_per_order = 16;
/// A simulation is given up when two bodies overlap by more than this part of the smaller radius. A grain pinned in the
/// corner of two bead walls may reach half of it in earnest.
constexpr double deepest_overlap = 1.0;

double sum(const double (&slots)[block]) {
  double s = 0;
  for (const double a : slots) s += a;
  return s;
}

}  // namespace

template <int D>
Engine<D>::Engine(const EngineSetup<D>& setup, const Kernels& kernels)
    : kernels_(&kernels),
      kind_(setup.kind),
      grain_law_(setup.grain_law),
      wall_law_(setup.wall_law),
      scheme_(setup.scheme),
      dt_(setup.dt),
      walls_(setup.walls),
      box_(setup.box),
      gravity_(setup.gravity) {
  using R = Row<D>;
  std::size_t beads = 0;
  for (const auto& wall : walls_) {
    first_bead_.push_back(setup.radius.size() + beads);
    beads += wall.beads.size();
  }
  wall_force_.assign(walls_.size(), Vec<D>{});
  parts_ = Parts(D, setup.radius.size(), beads);
  bodies_.resize(setup.radius.size(), beads, parts_.with_grains(), scheme_ == Scheme::gear5);
  sums_.resize(parts_.with_grains());
  for (Sums& sums : sums_) sums.wall_force.resize(walls_.size());
  double mean = 0;
  smallest_ = setup.radius.empty() ? 0 : setup.radius[0];
  for (std::size_t k = 0; k < setup.radius.size(); ++k) {
    double* row = bodies_.row(k);
    row[R::radius] = setup.radius[k];
    bodies_.inverse[2 * k] = 1 / setup.mass[k];
    bodies_.inverse[2 * k + 1] = 1 / setup.inertia[k];
    for (std::size_t c = 0; c < D; ++c) {
      row[c] = setup.position[k][static_cast<int>(c)];
      row[R::velocity + c] = setup.velocity[k][static_cast<int>(c)];
    }
    if constexpr (D == 2) {
      if (!setup.spin.empty()) row[R::spin] = setup.spin[k];
    } else {
      if (!setup.spin.empty())
        for (std::size_t c = 0; c < 3; ++c) row[R::spin + c] = setup.spin[k][static_cast<int>(c)];
    }
    bodies_.mass[k] = setup.mass[k];
    if (!setup.species.empty()) bodies_.species[k] = setup.species[k];
    mean += 2 * setup.radius[k];
    smallest_ = std::min(smallest_, setup.radius[k]);
  }
  if (!setup.radius.empty()) diameter_ = mean / static_cast<double>(setup.radius.size());
  for (std::size_t w = 0; w < walls_.size(); ++w)
    for (std::size_t b = 0; b < walls_[w].beads.size(); ++b) {
      double* row = bodies_.row(first_bead_[w] + b);
      for (int c = 0; c < D; ++c) row[c] = walls_[w].beads[b][c];
      row[R::radius] = walls_[w].bead_radius;
    }
  for (std::size_t w = 0; w < walls_.size(); ++w) set_wall_velocity(w, walls_[w].velocity);
  shifts_ = image_shifts<D>(box_);

  // Start in step: the given velocities belong to time zero.
  const double dt = dt_;
  dt_ = 0;
  compute_forces();
  dt_ = dt;
  for (std::size_t k = 0; k < bodies_.grains; ++k)
    for (int m = 0; m < R::motions; ++m)
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t at = k * R::force_stride + 4 * static_cast<std::size_t>(m) + c;
        const bool turns = m == 1 || (D == 2 && c == 2);
        const double a = bodies_.forces[at] * (turns ? bodies_.inverse_inertia(k) : bodies_.inverse_mass(k));
        if (scheme_ == Scheme::verlet)
          bodies_.row(k)[R::velocity_of(m) + c] -= a * (dt_ / 2);
        else
          bodies_.derivatives[(k * R::motions + static_cast<std::size_t>(m)) * 12 + c] = a;
      }
  std::fill(bodies_.forces.begin(), bodies_.forces.end(), 0.0);
  std::fill(wall_force_.begin(), wall_force_.end(), Vec<D>{});
  damped_ = rubbed_ = wall_work_ = gravity_work_ = 0;
}

template <int D>
void Engine<D>::set_threads(int threads) {
  const int used = parts_.size() == 1 ? 1 : threads;
  if (used != team_->size()) team_ = std::make_unique<ThreadTeam>(used);
}

template <int D>
void Engine<D>::set_wall_velocity(std::size_t w, double velocity) {
  EngineWall<D>& wall = walls_[w];
  wall.velocity = velocity;
  const auto across = Row<D>::velocity + static_cast<std::size_t>(wall.axis);
  for (std::size_t b = 0; b < wall.beads.size(); ++b) bodies_.row(first_bead_[w] + b)[across] = velocity;
  if constexpr (D == 2) {
    const double inward = wall.high ? -velocity : velocity;
    for (std::size_t b = 0; b < wall.along.size(); ++b)
      bodies_.row(first_bead_[w] + b)[Row<D>::velocity + 1 - static_cast<std::size_t>(wall.axis)] =
          -2 * inward * wall.along[b];
  }
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
  const double closing = 2 * std::sqrt(speed2) * dt_;
  skin_ = std::clamp(std::sqrt(list_cost * diameter_ * closing), thinnest_skin * diameter_, widest_skin * diameter_);
  pairs_ = list_pairs<D>(bodies_, box_, skin_, pairs_, old_id, parts_, *team_);

  plane_grain_.clear(), plane_wall_.clear(), plane_spring_.clear();
  first_plane_.assign(1, 0);
  for (std::size_t part = 0; part < parts_.with_grains(); ++part) {
    for (std::size_t w = 0; w < walls_.size(); ++w) {
      if (walls_[w].kind != WallKind::plane) continue;
      const double sign = walls_[w].high ? -1.0 : 1.0;
      for (auto [k, end] = parts_.grains(part); k < end; ++k) {
        const double gap = sign * (bodies_.row(k)[walls_[w].axis] - walls_[w].position) - bodies_.radius(k);
        if (gap >= skin_) continue;
        plane_grain_.push_back(static_cast<std::uint32_t>(k));
        plane_wall_.push_back(static_cast<std::uint32_t>(w));
        plane_spring_.push_back(plane_spring[w * bodies_.grains + bodies_.id[k]]);
      }
    }
    first_plane_.push_back(plane_grain_.size());
  }
  moved_ = 0;
  watch_until_ = -1;
  closing_ = closing;
  stale_ = false;
}

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

template <int D>
void Engine<D>::compute_forces() {
  if (stale_) relist();
  if (!(moved_ < watch_until_)) watch_near();
  for (Sums& sums : sums_) {
    for (auto* slots : {&sums.tally.damped, &sums.tally.rubbed, &sums.tally.virial})
      std::fill(std::begin(*slots), std::end(*slots), 0.0);
    std::fill(sums.wall_force.begin(), sums.wall_force.end(), Vec<D>{});
  }
  for (std::size_t round = 0; round + 1 < pairs_.first_of_round.size(); ++round) {
    const std::size_t first = pairs_.first_of_round[round];
    team_->run(pairs_.first_of_round[round + 1] - first, [&](std::size_t g) { sum_pairs(first + g); });
  }
  const bool falling = dot(gravity_, gravity_) > 0;
  if (falling || !plane_grain_.empty())
    team_->run(parts_.with_grains(), [&](std::size_t part) {
      touch_planes(part);
      if (falling) pull_down(part);
    });
  add_up();
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

/// Books what the parts have summed, in their order.
template <int D>
void Engine<D>::add_up() {
  double damped = 0, rubbed = 0, virial = 0, gravity_power = 0;
  for (const Sums& sums : sums_) {
    damped += sum(sums.tally.damped);
    rubbed += sum(sums.tally.rubbed);
    virial += sum(sums.tally.virial);
    gravity_power += sums.gravity_power;
    for (std::size_t w = 0; w < walls_.size(); ++w) wall_force_[w] += sums.wall_force[w];
  }
  gravity_work_ += gravity_power * dt_;
  collect_walls();
  damped_ += damped * dt_;
  rubbed_ += rubbed;
  if (box_speed_ != 0) wall_work_ += 2 * box_speed_ * dt_ / box_.length[0] * virial;
}

template <int D>
void Engine<D>::touch_planes(std::size_t part) {
  using R = Row<D>;
  Tally& tally = sums_[part].tally;
  std::vector<Vec<D>>& wall_force = sums_[part].wall_force;
  for (std::size_t q = first_plane_[part]; q < first_plane_[part + 1]; ++q) {
    const std::size_t k = plane_grain_[q], w = plane_wall_[q];
    const EngineWall<D>& wall = walls_[w];
    const double* row = bodies_.row(k);
    const double sign = wall.high ? -1.0 : 1.0, distance = sign * (row[wall.axis] - wall.position);
    const double x = row[R::radius] - distance;
    Axial<D>& spring = plane_spring_[q];
    if (!(x > 0)) {
      if (!hertzian(kind_)) tally.rubbed[0] += spring_energy(wall_law_.k_t, spring);
      spring = Axial<D>{};
      continue;
    }
    Vec<D> n{}, v;
    n[wall.axis] = -sign;
    for (int c = 0; c < D; ++c) v[c] = row[R::velocity + static_cast<std::size_t>(c)];
    v[wall.axis] -= wall.velocity;
    const double lever = row[R::radius] - wall_law_.lever_cut * x;
    double* f = bodies_.forces.data() + k * R::force_stride;
    with_law(kind_, [&]<NormalLaw law>() {
      const Axial<D> lw = levered_spin<D>(row, lever);
      const auto t = touch<D, law, true>(wall_law_, n, x, bodies_.mass[k], v, lw, spring, dt_);
      Vec<D> force;
      if constexpr (D == 2) {
        force = {-t.normal * n[0] - t.tangential * n[1], -t.normal * n[1] + t.tangential * n[0]};
        f[2] += lever * t.tangential;
      } else {
        force = (-t.normal) * n + t.tangential;
        const Vec<3> twist = cross(n, t.tangential);
        for (int c = 0; c < 3; ++c) f[4 + c] += lever * twist[c];
      }
      for (int c = 0; c < D; ++c) f[c] += force[c];
      wall_force[w] -= force;
      tally.damped[0] += t.damped;
      tally.rubbed[0] += t.rubbed;
      tally.deepest[0] = larger(tally.deepest[0], x);
    });
  }
}

template <int D>
void Engine<D>::pull_down(std::size_t part) {
  double power = 0;
  for (auto [k, end] = parts_.grains(part); k < end; ++k) {
    const double* v = bodies_.row(k) + Row<D>::velocity;
    double* f = bodies_.forces.data() + k * Row<D>::force_stride;
    for (int c = 0; c < D; ++c) {
      f[c] += bodies_.mass[k] * gravity_[c];
      power += bodies_.mass[k] * gravity_[c] * v[c];
    }
  }
  sums_[part].gravity_power = power;
}

template <int D>
void Engine<D>::collect_walls() {
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    Vec<D>& force = wall_force_[w];
    for (std::size_t b = first_bead_[w]; b < first_bead_[w] + walls_[w].beads.size(); ++b)
      for (int c = 0; c < D; ++c) force[c] += bodies_.forces[b * Row<D>::force_stride + static_cast<std::size_t>(c)];
    wall_work_ -= force[walls_[w].axis] * walls_[w].velocity * dt_;
    if constexpr (D == 2) {
      const auto along = 1 - static_cast<std::size_t>(walls_[w].axis);
      for (std::size_t b = first_bead_[w]; b < first_bead_[w] + walls_[w].along.size(); ++b)
        wall_work_ -= bodies_.forces[b * Row<D>::force_stride + along] * bodies_.row(b)[Row<D>::velocity + along] * dt_;
    }
  }
}

template <int D>
void Engine<D>::move_bodies(std::size_t part) {
  const auto [begin, end] = parts_.bodies(part);
  BodyArrays b{bodies_.rows.data() + begin * Row<D>::stride,
               bodies_.forces.data() + begin * Row<D>::force_stride,
               bodies_.inverse.data() + 2 * begin,
               bodies_.derivatives.data() + (bodies_.derivatives.empty() ? 0 : begin * 12 * Row<D>::motions),
               bodies_.calm.data() + (bodies_.calm.empty() ? 0 : begin),
               end - begin,
               dt_,
               pairs_.touching() < bodies_.grains / 8,
               {}};
  (scheme_ == Scheme::verlet ? kernels_->template verlet<D>() : kernels_->template gear<D>())(b);
  std::copy(std::begin(b.fastest), std::end(b.fastest), sums_[part].fastest.begin());
}

template <int D>
void Engine<D>::advance() {
  team_->run(parts_.with_grains(), [&](std::size_t part) { move_bodies(part); });
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
  closing_ = 2 * std::sqrt(speed2) * dt_;
  stale_ = stale_ || !(2 * moved_ < skin_);
  ++step_;
  if (step_ % 64 == 0) {
    double deepest = 0;
    for (Sums& sums : sums_)
      for (double& d : sums.tally.deepest) deepest = std::max(deepest, d), d = 0;
    if (deepest > deepest_overlap * smallest_ || step_ % 1024 == 0) check();
  }
}

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
  moved_ += strain * diameter_;
}

template <int D>
void Engine<D>::run(std::int64_t n) {
  for (; n > 0; --n) {
    compute_forces();
    advance();
  }
}

template <int D>
void Engine<D>::check() const {
  for (std::size_t k = 0; k < bodies_.count(); ++k)
    for (std::size_t c = 0; c < Row<D>::stride; ++c)
      if (!std::isfinite(bodies_.row(k)[c])) fail(k, "has a position or velocity that is not a number");
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    if (pairs_.i[k] >= bodies_.grains) continue;
    Vec<D> d = bodies_.position(pairs_.j[k]) - bodies_.position(pairs_.i[k]);
    for (int c = 0; c < D; ++c) d[c] += shifts_[4 * pairs_.shift[k] + static_cast<std::size_t>(c)];
    const double overlap = bodies_.radius(pairs_.i[k]) + bodies_.radius(pairs_.j[k]) - norm(d);
    if (overlap > deepest_overlap * std::min(bodies_.radius(pairs_.i[k]), bodies_.radius(pairs_.j[k])))
      fail(pairs_.i[k], "overlaps its neighbour by " + std::to_string(overlap) + ", more than a radius");
  }
}

template <int D>
void Engine<D>::fail(std::size_t body, const std::string& problem) const {
  std::string place;
  for (int c = 0; c < D; ++c) place += (c ? ", " : "") + std::to_string(bodies_.row(body)[c]);
  throw Diverged("step " + std::to_string(step_) + ": " +
                 (body < bodies_.grains ? "grain " + std::to_string(bodies_.id[body])
                                        : "wall bead " + std::to_string(body - bodies_.grains)) +
                 " at (" + place + ") " + problem +
                 "; likely the time step is too long for the stiffness, or the walls are too fast");
}

template class Engine<2>;
template class Engine<3>;

}  // namespace jam
