// The bodies of a simulation: grains, then wall beads, then two far-away dummies for each part that fill up its last
// blocks of pairs.
// Grains are kept in spatial order; `id` says who is who.
#pragma once

#include <cstdint>
#include <vector>

#include "jamscape/dem/rows.hpp"
#include "jamscape/geometry/vec.hpp"

namespace jam {

template <int D>
struct Bodies {
  std::size_t grains = 0, beads = 0;
  // hot: every contact reads the rows, every step writes them
  Spread<double> rows;    ///< see Row<D>
  Spread<double> forces;  ///< cleared by the integrator
  // warm: read by the integrator once a step
  Aligned<double> inverse;         ///< 1/m and 1/I of each body
  Aligned<double> derivatives;     ///< Gear only: acceleration, jerk, snap a motion
  std::vector<std::uint8_t> calm;  ///< Gear only: see BodyArrays; follows from the derivatives
  // cold
  std::vector<std::uint32_t> id;  ///< of grains; beads have id = index
  std::vector<double> mass;       ///< of grains
  std::vector<std::int32_t> species;

  std::size_t count() const { return grains + beads; }
  double* row(std::size_t k) { return rows.data() + k * Row<D>::stride; }
  const double* row(std::size_t k) const { return rows.data() + k * Row<D>::stride; }
  Vec<D> position(std::size_t k) const {
    Vec<D> x;
    for (int c = 0; c < D; ++c) x[c] = row(k)[c];
    return x;
  }
  double inverse_mass(std::size_t k) const { return inverse[2 * k]; }
  double inverse_inertia(std::size_t k) const { return inverse[2 * k + 1]; }
  double radius(std::size_t k) const { return row(k)[Row<D>::radius]; }

  /// The first dummy of a part; the other one follows.
  std::uint32_t nobody(std::size_t part) const { return static_cast<std::uint32_t>(count() + 2 * part); }

  /// Makes room for the given numbers of grains and beads, all zero, and places the dummies.
  void resize(std::size_t grain_count, std::size_t bead_count, std::size_t parts, bool with_derivatives);
  /// Grain k becomes the one that was at order[k].
  void reorder(const std::vector<std::uint32_t>& order);
};

extern template struct Bodies<2>;
extern template struct Bodies<3>;

}  // namespace jam
