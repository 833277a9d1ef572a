// Energies of an instant, without its contact record.
#include <cmath>

#include "jamscape/dem/engine.hpp"

namespace jam {

template <int D>
double Engine<D>::kinetic_energy() const {
  using R = Row<D>;
  double sum = 0;
  for (std::size_t k = 0; k < bodies_.grains; ++k) {
    const double* row = bodies_.row(k);
    for (std::size_t c = 0; c < D; ++c) sum += 0.5 * bodies_.mass[k] * row[R::velocity + c] * row[R::velocity + c];
    for (std::size_t c = 0; c < (D == 2 ? 1 : 3); ++c)
      sum += 0.5 * row[R::spin + c] * row[R::spin + c] / bodies_.inverse_inertia(k);
  }
  return sum;
}

template <int D>
ElasticEnergy Engine<D>::elastic_energy() const {
  using R = Row<D>;
  ElasticEnergy sum;
  const auto add = [&](const PairLaw<>& law, double x, const Axial<D>& spring) {
    with_law(kind_, [&]<NormalLaw normal>() { sum.add<normal>(law, x, spring); });
  };
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const std::uint32_t i = pairs_.i[k], j = pairs_.j[k];
    if (i >= bodies_.grains) continue;  // padding
    const bool bead = j >= bodies_.grains;
    Vec<D> d = bodies_.position(j) - bodies_.position(i);
    if (!bead)
      for (int c = 0; c < D; ++c) d[c] += shifts_[4 * pairs_.shift[k] + static_cast<std::size_t>(c)];
    const double x = bodies_.radius(i) + bodies_.radius(j) - norm(d);
    if (!(x > 0)) continue;
    if constexpr (D == 2)
      add(bead ? wall_law_ : grain_law_, x, *pairs_.spring(k));
    else
      add(bead ? wall_law_ : grain_law_, x,
          Vec<3>{pairs_.spring(k)[0], pairs_.spring(k)[block], pairs_.spring(k)[2 * block]});
  }
  for (std::size_t q = 0; q < plane_grain_.size(); ++q) {
    const EngineWall<D>& wall = walls_[plane_wall_[q]];
    const double* row = bodies_.row(plane_grain_[q]);
    const double x = row[R::radius] - (wall.high ? -1.0 : 1.0) * (row[wall.axis] - wall.position);
    if (x > 0) add(wall_law_, x, plane_spring_[q]);
  }
  return sum;
}

template double Engine<2>::kinetic_energy() const;
template double Engine<3>::kinetic_energy() const;
template ElasticEnergy Engine<2>::elastic_energy() const;
template ElasticEnergy Engine<3>::elastic_energy() const;

}  // namespace jam
