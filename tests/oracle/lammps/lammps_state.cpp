#include "lammps_state.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

namespace jam::lammps {
namespace {

/// The components of a spin, torque or spring, one in two dimensions.
template <int D>
constexpr std::size_t axes = D == 2 ? 1 : 3;

double part(double a, std::size_t) { return a; }
double part(const Vec3& a, std::size_t c) { return a[static_cast<int>(c)]; }

}  // namespace

PairLaw<> pair_law(const Law& law, double scale) {
  PairLaw<> out{};
  out.k_n = scale * law.k_n, out.gamma_n = scale * law.gamma_n;
  out.k_t = scale * law.k_t, out.gamma_t = scale * law.gamma_t;
  out.inverse_k_t = out.k_t > 0 ? 1 / out.k_t : 0;
  out.mu = law.mu;
  out.lever_cut = 0;
  out.floor = -std::numeric_limits<double>::infinity();
  return out;
}

template <int D>
Vec<D> State<D>::between(std::size_t i, std::size_t j) const {
  Vec<D> d = position[j] - position[i];
  for (int c = 0; c < D; ++c)
    if (const double period = box.length[static_cast<std::size_t>(c)]; period > 0)
      d[c] -= period * std::round(d[c] / period);
  return d;
}

template <int D>
Axial<D> State<D>::spring(std::size_t i, std::size_t j, const Vec<D>& n, double x) const {
  Vec<D> on_i{};
  if (const auto at = spring_force.find({i, j}); at != spring_force.end())
    on_i = at->second;
  else if (const auto turned = spring_force.find({j, i}); turned != spring_force.end())
    on_i = -1.0 * turned->second;
  const double stiffness = (kind == NormalLaw::hertz ? std::sqrt(x) : 1.0) * law.k_t;
  if constexpr (D == 2)
    return -(n[0] * on_i[1] - n[1] * on_i[0]) / stiffness;
  else
    return (-1 / stiffness) * on_i;
}

template <int D>
EngineSetup<D> setup_of(const State<D>& s) {
  EngineSetup<D> setup;
  setup.radius = s.radius, setup.mass = s.mass;
  for (std::size_t k = 0; k < s.size(); ++k) setup.inertia.push_back(s.inertia(k));
  setup.position = s.position, setup.velocity = s.velocity, setup.spin = s.spin;
  setup.walls = s.walls, setup.box = s.box;
  setup.kind = s.kind, setup.grain_law = s.law, setup.wall_law = s.wall_law;
  setup.dt = s.dt;
  return setup;
}

template <int D>
Engine<D> enter(const State<D>& s) {
  using R = Row<D>;
  EngineSetup<D> setup = setup_of(s);
  for (std::size_t k = 0; k < s.size(); ++k) {
    setup.velocity[k] += (s.dt / 2 / s.mass[k]) * s.force[k];
    setup.spin[k] = setup.spin[k] + (s.dt / 2 / s.inertia(k)) * s.torque[k];
    setup.position[k] += s.dt * setup.velocity[k];
  }
  Engine<D> engine(setup);

  // The engine starts without springs and takes velocities as those of a full step; its checkpoint says otherwise.
  Archive state;
  engine.save(state);
  using Reals = std::vector<double>;
  using Integers = std::vector<std::int64_t>;
  const auto& id = std::get<Integers>(state.at("engine/id"));
  auto& rows = std::get<Reals>(state.at("engine/rows"));
  for (std::size_t k = 0; k < s.size(); ++k) {
    double* row = rows.data() + k * R::stride;
    const auto a = static_cast<std::size_t>(id[k]);
    for (std::size_t c = 0; c < D; ++c) row[R::velocity + c] = setup.velocity[a][static_cast<int>(c)];
    for (std::size_t c = 0; c < axes<D>; ++c) row[R::spin + c] = part(setup.spin[a], c);
  }
  const auto &from = std::get<Integers>(state.at("engine/pair_i")), &to = std::get<Integers>(state.at("engine/pair_j"));
  auto& springs = std::get<Reals>(state.at("engine/pair_spring"));
  for (std::size_t k = 0; k < from.size(); ++k) {
    const auto i = static_cast<std::size_t>(from[k]), j = static_cast<std::size_t>(to[k]);
    if (i >= s.size() || j >= s.size()) continue;
    const auto a = static_cast<std::size_t>(id[i]), b = static_cast<std::size_t>(id[j]);
    const Vec<D> d = s.between(a, b);
    const double r = norm(d), x = s.radius[a] + s.radius[b] - r;
    if (!(x > 0)) continue;
    const Axial<D> spring = s.spring(a, b, (1 / r) * d, x);
    const std::size_t at = D == 2 ? k : k / block * 3 * block + k % block;
    for (std::size_t c = 0; c < axes<D>; ++c) springs[at + c * block] = part(spring, c);
  }
  engine.load(state);
  return engine;
}

template struct State<2>;
template struct State<3>;
template EngineSetup<2> setup_of(const State<2>&);
template EngineSetup<3> setup_of(const State<3>&);
template Engine<2> enter(const State<2>&);
template Engine<3> enter(const State<3>&);

}  // namespace jam::lammps
