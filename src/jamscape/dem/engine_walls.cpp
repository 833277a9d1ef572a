// Walls and gravity.
#include <algorithm>
#include <cmath>

#include "jamscape/dem/engine.hpp"
#include "jamscape/dem/spin.hpp"

namespace jam {

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

/// Grains may be hit while they are at rest: planes age the list as bodies do (beads are bodies).
template <int D>
double Engine<D>::fastest_plane() const {
  double fastest = 0;
  for (const EngineWall<D>& wall : walls_)
    if (wall.kind == WallKind::plane) fastest = std::max(fastest, std::abs(wall.velocity));
  return fastest;
}

template <int D>
void Engine<D>::touch_planes(std::size_t part, std::size_t stretch) {
  using R = Row<D>;
  Tally& tally = sums_[part].tally;
  std::vector<Vec<D>>& wall_force = sums_[part].wall_force;
  for (std::size_t q = first_plane_[stretch]; q < first_plane_[stretch + 1]; ++q) {
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
void Engine<D>::pull_down(std::size_t part, std::size_t stretch) {
  double power = 0;
  for (auto [k, end] = parts_.stretch(stretch); k < end; ++k) {
    const double* v = bodies_.row(k) + Row<D>::velocity;
    double* f = bodies_.forces.data() + k * Row<D>::force_stride;
    for (int c = 0; c < D; ++c) {
      f[c] += bodies_.mass[k] * gravity_[c];
      power += bodies_.mass[k] * gravity_[c] * v[c];
    }
  }
  sums_[part].gravity_power += power;
}

/// The forces on walls of beads are complete before those within the last part, which the beads are moved with.
template <int D>
void Engine<D>::collect_beads() {
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    if (walls_[w].kind != WallKind::beads) continue;
    Vec<D>& force = wall_force_[w];
    for (std::size_t b = first_bead_[w]; b < first_bead_[w] + walls_[w].beads.size(); ++b)
      for (int c = 0; c < D; ++c) force[c] += bodies_.forces[b * Row<D>::force_stride + static_cast<std::size_t>(c)];
    booked_.wall_work -= force[walls_[w].axis] * walls_[w].velocity * dt_;
    if constexpr (D == 2) {
      const auto along = 1 - static_cast<std::size_t>(walls_[w].axis);
      for (std::size_t b = first_bead_[w]; b < first_bead_[w] + walls_[w].along.size(); ++b)
        booked_.wall_work -= bodies_.forces[b * Row<D>::force_stride + along] * bodies_.row(b)[Row<D>::velocity + along] * dt_;
    }
  }
}

#define JAM_INSTANTIATE(D)                                         \
  template void Engine<D>::set_wall_velocity(std::size_t, double); \
  template double Engine<D>::fastest_plane() const;                \
  template void Engine<D>::touch_planes(std::size_t, std::size_t); \
  template void Engine<D>::pull_down(std::size_t, std::size_t);    \
  template void Engine<D>::collect_beads();
JAM_INSTANTIATE(2)
JAM_INSTANTIATE(3)

}  // namespace jam
