// Our side of bench/peers/run_engine: steps a packing that LAMMPS made, from LAMMPS's own state.
//
//   engine_bench state FILE STEPS    JSON: the forces of every contact at LAMMPS's step 0 by our law; positions,
//                                    velocities, spins and forces of the grains at its steps 1 and STEPS by our engine
//   engine_bench time FILE STEPS     JSON: seconds of the stepping loop alone
//
// LAMMPS's set-up evaluates forces with full-step velocities and leaves the springs alone, unlike every step after it.
// So we enter one step later: v(1/2) = v(0) + f(0)/m dt/2 with LAMMPS's f(0), x(1) = x(0) + v(1/2) dt, springs of
// step 0.
#include <fmt/core.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "jamscape/base/error.hpp"
#include "jamscape/dem/engine.hpp"

namespace {

using jam::Vec2;

/// As LAMMPS dumped it at step 0. Springs times k_t, as the tangential force on the first grain.
struct State {
  double side = 0, dt = 0;
  jam::PairLaw<> law{};
  std::vector<Vec2> position, velocity, force;
  std::vector<double> spin, torque, radius, mass;
  std::map<std::pair<std::size_t, std::size_t>, Vec2> spring_force;

  std::size_t size() const { return position.size(); }
  Vec2 nearest(Vec2 d) const {
    for (int c = 0; c < 2; ++c) d[c] -= side * std::round(d[c] / side);
    return d;
  }
};

State read(const std::string& path) {
  std::ifstream in(path);
  State s;
  std::map<std::string, double> value;
  std::string key;
  while (in >> key && key != "grains") in >> value[key];
  auto number = [&](const char* name) {
    if (!value.count(name)) throw jam::data_error(fmt::format("'{}' is missing", name), path);
    return value[name];
  };
  s.side = number("side"), s.dt = number("dt");
  s.law = {.k_n = number("k_n"),
           .gamma_n = number("gamma_n"),
           .k_t = number("k_t"),
           .gamma_t = number("gamma_t"),
           .inverse_k_t = 1 / number("k_t"),
           .mu = number("mu"),
           .lever_cut = 0,
           .floor = -std::numeric_limits<double>::infinity(),
           .damping_limit = std::numeric_limits<double>::infinity()};
  std::size_t n = 0;
  in >> n;
  for (std::size_t k = 0; k < n; ++k) {
    Vec2 x, v, f;
    double spin, radius, mass, torque;
    in >> x[0] >> x[1] >> v[0] >> v[1] >> spin >> radius >> mass >> f[0] >> f[1] >> torque;
    s.position.push_back(x), s.velocity.push_back(v), s.force.push_back(f);
    s.spin.push_back(spin), s.radius.push_back(radius), s.mass.push_back(mass), s.torque.push_back(torque);
  }
  in >> key >> n;
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t i, j;
    Vec2 f;
    in >> i >> j >> f[0] >> f[1];
    s.spring_force[{i, j}] = f;
  }
  if (!in || s.size() == 0) throw jam::data_error("the packing ends early", path, "remove it and run again");
  return s;
}

/// The spring of our law along t = (-n_y, n_x), n from i to j; the same seen from either end.
double spring_of(const State& s, std::size_t i, std::size_t j, const Vec2& n) {
  const Vec2 t{-n[1], n[0]};
  if (const auto at = s.spring_force.find({i, j}); at != s.spring_force.end()) return -dot(at->second, t) / s.law.k_t;
  if (const auto at = s.spring_force.find({j, i}); at != s.spring_force.end()) return dot(at->second, t) / s.law.k_t;
  return 0;
}

jam::Engine<2> enter(const State& s) {
  jam::EngineSetup<2> setup;
  setup.radius = s.radius, setup.mass = s.mass, setup.spin = s.spin;
  for (std::size_t k = 0; k < s.size(); ++k) {
    setup.inertia.push_back(0.5 * s.mass[k] * s.radius[k] * s.radius[k]);
    setup.velocity.push_back(s.velocity[k] + (s.dt / 2 / s.mass[k]) * s.force[k]);
    setup.spin[k] += s.dt / 2 / setup.inertia[k] * s.torque[k];
    Vec2 x = s.position[k] + s.dt * setup.velocity[k];
    for (int c = 0; c < 2; ++c) x[c] -= s.side * std::floor(x[c] / s.side);
    setup.position.push_back(x);
  }
  setup.box.length = {s.side, s.side};
  setup.grain_law = setup.wall_law = s.law;
  setup.dt = s.dt;
  jam::Engine<2> engine(setup);

  // The engine starts without springs and takes velocities as those of a full step; its checkpoint says otherwise.
  jam::Archive state;
  engine.save(state);
  using Reals = std::vector<double>;
  using Integers = std::vector<std::int64_t>;
  const auto& id = std::get<Integers>(state.at("engine/id"));
  auto& rows = std::get<Reals>(state.at("engine/rows"));
  for (std::size_t k = 0; k < s.size(); ++k) {
    double* row = rows.data() + k * jam::Row<2>::stride;
    const auto a = static_cast<std::size_t>(id[k]);
    row[jam::Row<2>::velocity] = setup.velocity[a][0];
    row[jam::Row<2>::velocity + 1] = setup.velocity[a][1];
    row[jam::Row<2>::spin] = setup.spin[a];
  }
  const auto &from = std::get<Integers>(state.at("engine/pair_i")), &to = std::get<Integers>(state.at("engine/pair_j"));
  auto& springs = std::get<Reals>(state.at("engine/pair_spring"));
  for (std::size_t k = 0; k < from.size(); ++k) {
    const auto i = static_cast<std::size_t>(from[k]), j = static_cast<std::size_t>(to[k]);
    if (i >= s.size() || j >= s.size()) continue;
    const auto a = static_cast<std::size_t>(id[i]), b = static_cast<std::size_t>(id[j]);
    const Vec2 d = s.nearest(s.position[b] - s.position[a]);
    springs[k] = spring_of(s, a, b, (1 / norm(d)) * d);
  }
  engine.load(state);
  return engine;
}

/// [[i, j, F_n, f_t on i], ...] of all touching pairs at step 0.
std::string contacts(const State& s) {
  std::string out;
  for (std::size_t i = 0; i < s.size(); ++i)
    for (std::size_t j = i + 1; j < s.size(); ++j) {
      const Vec2 d = s.nearest(s.position[j] - s.position[i]);
      const double r = norm(d), reach = s.radius[i] + s.radius[j];
      if (!(r < reach)) continue;
      const Vec2 n = (1 / r) * d;
      double spring = spring_of(s, i, j, n);
      const auto f = jam::touch<2, jam::NormalLaw::linear, true>(
          s.law, n, reach - r, s.mass[i] * s.mass[j] / (s.mass[i] + s.mass[j]), s.velocity[i] - s.velocity[j],
          s.radius[i] * s.spin[i] + s.radius[j] * s.spin[j], spring, 0.0);
      out += fmt::format("{}[{},{},{},{},{}]", out.empty() ? "" : ",\n", i, j, f.normal, -f.tangential * n[1],
                         f.tangential * n[0]);
    }
  return "[" + out + "]";
}

/// [[x, y, v_x, v_y, spin, f_x, f_y], ...] by grain.
std::string grains(const jam::Packing& p) {
  std::vector<jam::Vec3> force(p.grains.size());
  for (std::size_t k = 0; k < p.contacts.size(); ++k) {
    const jam::Vec3 f = (-p.contacts.normal_force[k]) * p.contacts.normal[k] + p.contacts.tangential_force[k];
    force[p.contacts.i[k]] += f;
    force[static_cast<std::size_t>(p.contacts.j[k])] -= f;
  }
  std::string out;
  for (std::size_t k = 0; k < p.grains.size(); ++k) {
    const auto &x = p.grains.position[k], &v = p.grains.velocity[k];
    out += fmt::format("{}[{},{},{},{},{},{},{}]", out.empty() ? "" : ",\n", x[0], x[1], v[0], v[1],
                       p.grains.spin[k][2], force[k][0], force[k][1]);
  }
  return "[" + out + "]";
}

int run(const std::string& mode, const std::string& path, std::int64_t steps) {
  const State s = read(path);
  jam::Engine<2> engine = enter(s);
  if (mode == "time") {
    const auto start = std::chrono::steady_clock::now();
    engine.run(steps);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::cout << fmt::format("{{\"seconds\": {}, \"kernels\": \"{}\"}}\n", seconds.count(), jam::best_kernels().name);
    return 0;
  }
  if (mode != "state" || steps < 2) throw jam::usage_error("the mode is state (at least 2 steps) or time");
  engine.compute_forces();
  const jam::Packing first = engine.record();
  engine.advance();
  engine.run(steps - 2);
  engine.compute_forces();
  std::cout << "{\"contacts\": " << contacts(s) << ",\n\"first\": " << grains(first)
            << ",\n\"last\": " << grains(engine.record()) << "}\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 4) throw jam::usage_error("usage: engine_bench state|time FILE STEPS");
  return run(argv[1], argv[2], std::atoll(argv[3]));
} catch (const std::exception& error) {
  std::cerr << "engine_bench: " << error.what() << "\n";
  return 1;
}
