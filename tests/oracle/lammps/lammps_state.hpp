// A packing at one instant of a LAMMPS run (gran/hooke/history or gran/hertz/history, fix nve/sphere), and our engine
// entering it.
//
// LAMMPS integrates like our Verlet scheme: v(n+1/2) = v(n) + f(n)/m dt/2, x(n+1) = x(n) + v(n+1/2) dt, then f(n+1)
// from x(n+1), the half-step velocities and spins, and springs advanced by them. Its set-up is the exception: f(0) sees
// the full-step v(0) and leaves the springs alone. So we enter one step later, with LAMMPS's f(0): then nothing but
// round-off differs.
//
// Its Hertz law multiplies by sqrt(x R_i R_j / (R_i + R_j)), ours by sqrt(x): equal spheres are the same law with all
// four constants scaled by sqrt(R/2), against a flat wall by sqrt(R).
#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "jamscape/dem/engine.hpp"

namespace jam::lammps {

/// The arguments of a granular pair style or wall.
struct Law {
  double k_n = 0, k_t = 0, gamma_n = 0, gamma_t = 0, mu = 0;
};
/// The same law as ours, its four constants multiplied by `scale`.
PairLaw<> pair_law(const Law& law, double scale);

template <int D>
struct State {
  Periodic<D> box;
  std::vector<EngineWall<D>> walls;
  NormalLaw kind = NormalLaw::linear;
  PairLaw<> law{}, wall_law{};
  double dt = 0;
  std::vector<Vec<D>> position, velocity, force;
  std::vector<Axial<D>> spin, torque;
  std::vector<double> radius, mass;
  /// Of a pair that has a spring: the tangential force on the first grain that the spring alone would give.
  std::map<std::pair<std::size_t, std::size_t>, Vec<D>> spring_force;

  std::size_t size() const { return position.size(); }
  double inertia(std::size_t k) const { return (D == 2 ? 0.5 : 0.4) * mass[k] * radius[k] * radius[k]; }
  /// From grain i to the nearest copy of grain j.
  Vec<D> between(std::size_t i, std::size_t j) const;
  /// Our spring of the pair as seen from i, where n is the normal from i to j and x the overlap.
  Axial<D> spring(std::size_t i, std::size_t j, const Vec<D>& n, double x) const;
};

/// Our engine with these bodies at these velocities and no springs.
template <int D>
EngineSetup<D> setup_of(const State<D>& state);

/// Our engine at LAMMPS's next step: n steps of it give LAMMPS's step n + 1.
template <int D>
Engine<D> enter(const State<D>& state);

}  // namespace jam::lammps
