#include "jamscape/dem/engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace jam {

template <int D>
Engine<D>::Engine(const EngineSetup<D>& setup, const Kernels& kernels)
    : kernels_(&kernels),
      kind_(setup.kind),
      grain_law_(setup.grain_law),
      wall_law_(setup.wall_law),
      spring_turn_(setup.spring_turn),
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
    largest_ = std::max(largest_, setup.radius[k]);
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
  summed_ = false;
  booked_ = {};
}

template <int D>
int Engine<D>::set_threads(int wanted) {
  const int used = parts_.threads_of_use(wanted);
  if (used != team_->size()) team_ = std::make_unique<ThreadTeam>(used);
  return used;
}

/// A grain whose centre is beyond a plane, or beyond the line of a wall's bead centres, will not come back.
template <int D>
void Engine<D>::check_inside() const {
  for (const EngineWall<D>& wall : walls_)
    for (std::size_t k = 0; k < bodies_.grains; ++k) {
      const double beyond = (wall.high ? 1.0 : -1.0) * (bodies_.row(k)[wall.axis] - wall.position);
      if (!(beyond > 0)) continue;
      fail(k, "is outside its box, " + beyond_plane(beyond, wall.high, wall.axis, wall.position));
    }
}

template <int D>
void Engine<D>::check() const {
  const std::size_t odd = find_not_finite(bodies_.rows.data(), bodies_.count(), Row<D>::stride);
  if (odd < bodies_.count()) fail(odd, not_a_number);
  check_inside();
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    if (pairs_.i[k] >= bodies_.grains) continue;
    Vec<D> d = bodies_.position(pairs_.j[k]) - bodies_.position(pairs_.i[k]);
    for (int c = 0; c < D; ++c) d[c] += shifts_[4 * pairs_.shift[k] + static_cast<std::size_t>(c)];
    const double overlap = bodies_.radius(pairs_.i[k]) + bodies_.radius(pairs_.j[k]) - norm(d);
    if (overlap <= deepest_overlap * std::min(bodies_.radius(pairs_.i[k]), bodies_.radius(pairs_.j[k]))) continue;
    const std::string depth = std::to_string(overlap) + ", more than a radius";
    if (pairs_.j[k] < bodies_.grains) fail(pairs_.i[k], "overlaps its neighbour by " + depth);
    fail(pairs_.i[k], "is pressed into a wall bead by " + depth,
         "it is being squeezed out of the box, as happens in corners at high compression");
  }
}

/// In one step a body may not go farther than a radius: it would pass through others. `bound` is no less than the
/// largest speed.
template <int D>
void Engine<D>::check_speed(double bound) const {
  if (bound * dt_ < smallest_) return;
  for (std::size_t k = 0; k < bodies_.grains; ++k) {
    double v2 = 0;
    for (std::size_t c = 0; c < D; ++c) {
      const double v = bodies_.row(k)[Row<D>::velocity + c];
      v2 += v * v;
    }
    if (!(std::sqrt(v2) * dt_ < smallest_))
      fail(k, fmt::format("moves {:.3g} in one time step, more than the smallest radius", std::sqrt(v2) * dt_));
  }
}

/// What of the state makes grains go astray: a box too full, a step too long for the stiffness, or `otherwise`.
template <int D>
std::string Engine<D>::likely_cause(const std::string& otherwise) const {
  constexpr double overfull = D == 2 ? 0.95 : 0.8;  // of the box: everything overlaps by some percent
  constexpr double deep = 0.1;                      // overlap over diameter at which Hertz contacts are judged
  double room = 1;
  for (int axis = 0; axis < D; ++axis) {
    double lo = 0, hi = box_.length[static_cast<std::size_t>(axis)];
    for (const EngineWall<D>& wall : walls_)
      if (wall.axis == axis) (wall.high ? hi : lo) = wall.position;
    room *= hi - lo;
  }
  double filled = 0, lightest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < bodies_.grains; ++k) {
    const double r = bodies_.radius(k);
    filled += D == 2 ? std::numbers::pi * r * r : 4 * std::numbers::pi / 3 * r * r * r;
    lightest = std::min(lightest, bodies_.mass[k]);
  }
  if (room > 0 && filled > overfull * room)
    return fmt::format(
        "the box is too full: the {} of the grains is {:.3g} of it, whatever the packing fraction is counted by",
        D == 2 ? "area" : "volume", filled / room);
  const double k_n =
      std::max(grain_law_.k_n, wall_law_.k_n) * (hertzian(kind_) ? 1.5 * std::sqrt(deep * diameter_) : 1.0);
  const std::string too_long = step_too_long(dt_, lightest, k_n, "grains");
  return too_long.empty() ? otherwise : too_long;
}

template <int D>
void Engine<D>::fail(std::size_t body, const std::string& problem, const std::string& otherwise) const {
  throw diverged_at(step_,
                    body < bodies_.grains ? "grain " + std::to_string(bodies_.id[body])
                                          : "wall bead " + std::to_string(body - bodies_.grains),
                    {bodies_.row(body), D}, problem, likely_cause(otherwise));
}

template class Engine<2>;
template class Engine<3>;

}  // namespace jam
