// Tangential springs of spheres that turn with pairs about their own normal: by the mean spin of the two about it,
//
//   xi <- R(n, dt (w_i + w_j).n/2) xi
//
// Without it (the default: projection alone) a pair that turns as a whole about its normal keeps its spring where it
// was in the world, which no observer turning along would see (theory sec. 2.3). The rotation is Cayley's, which keeps
// the length of xi; its angle is right to third order in the step. A pass of its own, before the contact loops: they do
// not know of it. A wall does not spin.
#include "jamscape/dem/engine.hpp"

namespace jam {
namespace {

/// `xi` turned about the unit vector n by 2 atan(a).
Vec<3> turned_about(const Vec<3>& n, double a, const Vec<3>& xi) {
  const Vec<3> once = cross(n, xi);
  return xi + (2 * a / (1 + a * a)) * (once + a * cross(n, once));
}

Vec<3> spin(const double* row) {
  constexpr std::size_t at = Row<3>::spin;
  return {row[at], row[at + 1], row[at + 2]};
}

}  // namespace

template <int D>
void Engine<D>::twirl_springs() {
  if constexpr (D == 3) {
    const double quarter = dt_ / 4;  // half the angle, of the mean of two spins
    team_->run(pairs_.groups.size(), [&](std::size_t group) {
      for (std::size_t k = pairs_.groups[group].start[0]; k < pairs_.groups[group].start[pair_runs]; ++k) {
        double* stored = pairs_.spring(k);
        const Vec<3> xi{stored[0], stored[block], stored[2 * block]};
        if (dot(xi, xi) == 0) continue;
        const std::uint32_t i = pairs_.i[k], j = pairs_.j[k];
        Vec<3> d = bodies_.position(j) - bodies_.position(i);
        for (int c = 0; c < 3; ++c) d[c] += shifts_[4 * pairs_.shift[k] + static_cast<std::size_t>(c)];
        const Vec<3> n = (1 / norm(d)) * d;
        const Vec<3> now = turned_about(n, quarter * dot(spin(bodies_.row(i)) + spin(bodies_.row(j)), n), xi);
        for (int c = 0; c < 3; ++c) stored[static_cast<std::size_t>(c) * block] = now[c];
      }
    });
    for (std::size_t q = 0; q < plane_grain_.size(); ++q) {
      Vec<3> n{};
      n[walls_[plane_wall_[q]].axis] = 1;
      plane_spring_[q] = turned_about(n, quarter * dot(spin(bodies_.row(plane_grain_[q])), n), plane_spring_[q]);
    }
  }
}

template void Engine<2>::twirl_springs();
template void Engine<3>::twirl_springs();

}  // namespace jam
