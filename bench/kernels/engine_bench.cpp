// Our side of bench/peers/run_engine: steps a packing that LAMMPS made, from LAMMPS's own state.
//
//   engine_bench state FILE STEPS    JSON: the forces of every contact at LAMMPS's step 0 by our law; positions,
//                                    velocities, spins and forces of the grains at its steps 1 and STEPS by our engine
//   engine_bench time FILE STEPS     JSON: seconds of the stepping loop alone
//   engine_bench schemes FILE STEPS  JSON: the same with Verlet and with Gear, springs anew, after a tenth of the steps
//   engine_bench copies FILE STEPS THREADS COPIES
//                                    JSON: the same of COPIES x COPIES (x COPIES) such packings side by side, springs
//                                    anew, and the memory a grain takes; a tenth of the steps goes before the clock
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "jamscape/base/error.hpp"
#include "jamscape/base/flush_to_zero.hpp"
#include "lammps_state.hpp"

namespace {

using jam::Axial;
using jam::NormalLaw;
using jam::Vec;
using jam::lammps::State;

/// What stands before the grains: names and numbers.
std::map<std::string, double> read_header(std::istream& in) {
  std::map<std::string, double> value;
  std::string key;
  while (in >> key && key != "grains") in >> value[key];
  return value;
}

template <int D>
Vec<D> vector(std::istream& in) {
  Vec<D> v;
  for (int c = 0; c < D; ++c) in >> v[c];
  return v;
}
template <int D>
Axial<D> axial(std::istream& in) {
  if constexpr (D == 2) {
    double a;
    in >> a;
    return a;
  } else {
    return vector<3>(in);
  }
}

/// The packing at LAMMPS's step 0: a periodic square or cube. A row a grain: position, velocity, spin, radius, mass,
/// force, torque; a row a spring: grains i, j and the tangential force on i.
template <int D>
State<D> read(std::istream& in, const std::map<std::string, double>& value, const std::string& path) {
  auto number = [&](const char* name) {
    if (!value.count(name)) throw jam::data_error(fmt::format("'{}' is missing", name), path);
    return value.at(name);
  };
  State<D> s;
  s.box.length.fill(number("side"));
  s.dt = number("dt");
  s.kind = number("hertz") != 0 ? NormalLaw::hertz : NormalLaw::linear;
  s.law = s.wall_law = jam::lammps::pair_law(
      {number("k_n"), number("k_t"), number("gamma_n"), number("gamma_t"), number("mu")}, number("scale"));
  std::size_t n = 0;
  in >> n;
  for (std::size_t k = 0; k < n; ++k) {
    s.position.push_back(vector<D>(in)), s.velocity.push_back(vector<D>(in)), s.spin.push_back(axial<D>(in));
    double radius, mass;
    in >> radius >> mass;
    s.radius.push_back(radius), s.mass.push_back(mass);
    s.force.push_back(vector<D>(in)), s.torque.push_back(axial<D>(in));
  }
  std::string key;
  in >> key >> n;
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t i, j;
    in >> i >> j;
    s.spring_force[{i, j}] = vector<D>(in);
  }
  if (!in || s.size() == 0) throw jam::data_error("the packing ends early", path, "remove it and run again");
  return s;
}

template <int D>
std::vector<double> numbers(const Vec<D>& v) {
  return {v.c, v.c + D};
}

/// [[i, j, F_n, f_t on i ...], ...] of all touching pairs at step 0.
template <int D, NormalLaw law>
std::string contacts(const State<D>& s) {
  jam::Engine<D> engine(jam::lammps::setup_of(s));
  engine.compute_forces();
  const jam::Contacts touching = engine.record().contacts;
  std::string out;
  for (std::size_t k = 0; k < touching.size(); ++k) {
    const std::size_t i = touching.i[k], j = static_cast<std::size_t>(touching.j[k]);
    const Vec<D> d = s.between(i, j);
    const double r = norm(d), x = s.radius[i] + s.radius[j] - r;
    const Vec<D> n = (1 / r) * d;
    Axial<D> spring = s.spring(i, j, n, x);
    const auto f = jam::touch<D, law, true>(s.law, n, x, s.mass[i] * s.mass[j] / (s.mass[i] + s.mass[j]),
                                            s.velocity[i] - s.velocity[j],
                                            s.radius[i] * s.spin[i] + s.radius[j] * s.spin[j], spring, 0.0);
    Vec<D> tangential;
    if constexpr (D == 2)
      tangential = {-f.tangential * n[1], f.tangential * n[0]};
    else
      tangential = f.tangential;
    out +=
        fmt::format("{}[{},{},{},{}]", out.empty() ? "" : ",\n", i, j, f.normal, fmt::join(numbers(tangential), ","));
  }
  return "[" + out + "]";
}

/// [[position, velocity, spin, force], ...] by grain, as many numbers each as the dimension asks for.
template <int D>
std::string grains(const jam::Packing& p) {
  std::vector<jam::Vec3> force(p.grains.size());
  for (std::size_t k = 0; k < p.contacts.size(); ++k) {
    const jam::Vec3 f = (-p.contacts.normal_force[k]) * p.contacts.normal[k] + p.contacts.tangential_force[k];
    force[p.contacts.i[k]] += f;
    force[static_cast<std::size_t>(p.contacts.j[k])] -= f;
  }
  std::string out;
  for (std::size_t k = 0; k < p.grains.size(); ++k) {
    std::vector<double> row;
    for (const auto* v : {&p.grains.position[k], &p.grains.velocity[k]}) row.insert(row.end(), v->c, v->c + D);
    row.insert(row.end(), p.grains.spin[k].c + (D == 2 ? 2 : 0), p.grains.spin[k].c + 3);
    row.insert(row.end(), force[k].c, force[k].c + D);
    out += fmt::format("{}[{}]", out.empty() ? "" : ",\n", fmt::join(row, ","));
  }
  return "[" + out + "]";
}

template <int D>
double seconds_of(jam::Engine<D>& engine, std::int64_t steps) {
  const auto start = std::chrono::steady_clock::now();
  engine.run(steps);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <int D>
int compare_schemes(const State<D>& s, std::int64_t steps) {
  std::map<jam::Scheme, double> seconds;
  for (const jam::Scheme scheme : {jam::Scheme::verlet, jam::Scheme::gear5}) {
    jam::EngineSetup<D> setup = jam::lammps::setup_of(s);
    setup.scheme = scheme;
    jam::Engine<D> engine(setup);
    engine.run(steps / 10);
    seconds[scheme] = seconds_of(engine, steps);
  }
  std::cout << fmt::format("{{\"verlet\": {}, \"gear5\": {}}}\n", seconds[jam::Scheme::verlet],
                           seconds[jam::Scheme::gear5]);
  return 0;
}

template <int D>
int run(const std::string& mode, const State<D>& s, std::int64_t steps) {
  if (mode == "schemes") return compare_schemes(s, steps);
  jam::Engine<D> engine = enter(s);
  if (mode == "time") {
    const double seconds = seconds_of(engine, steps);
    std::cout << fmt::format("{{\"seconds\": {}, \"kernels\": \"{}\"}}\n", seconds, jam::best_kernels().name);
    return 0;
  }
  if (mode != "state" || steps < 2) throw jam::usage_error("the mode is state (at least 2 steps), time or schemes");
  engine.compute_forces();
  const jam::Packing first = engine.record();
  engine.advance();
  engine.run(steps - 2);
  engine.compute_forces();
  const auto at_start = s.kind == NormalLaw::hertz ? contacts<D, NormalLaw::hertz> : contacts<D, NormalLaw::linear>;
  std::cout << "{\"contacts\": " << at_start(s) << ",\n\"first\": " << grains<D>(first)
            << ",\n\"last\": " << grains<D>(engine.record()) << "}\n";
  return 0;
}

/// A line of /proc/self/status, in bytes.
double status_bytes(const std::string& name) {
  std::ifstream in("/proc/self/status");
  std::string word;
  while (in >> word)
    if (word == name + ":") {
      double kilobytes = 0;
      in >> kilobytes;
      return 1024 * kilobytes;
    }
  return std::nan("");
}

template <int D>
jam::EngineSetup<D> copy(const State<D>& s, int copies) {
  jam::EngineSetup<D> all = jam::lammps::setup_of(s);
  const jam::EngineSetup<D> one = all;
  for (auto& l : all.box.length) l *= copies;
  const int cells = D == 2 ? copies * copies : copies * copies * copies;
  for (int c = 1; c < cells; ++c) {
    const int at[3] = {c % copies, c / copies % copies, c / copies / copies};
    for (std::size_t k = 0; k < s.size(); ++k) {
      Vec<D> x = one.position[k];
      for (int e = 0; e < D; ++e) x[e] += at[e] * one.box.length[static_cast<std::size_t>(e)];
      all.position.push_back(x);
    }
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(all.velocity, one.velocity), append(all.spin, one.spin), append(all.radius, one.radius);
    append(all.mass, one.mass), append(all.inertia, one.inertia), append(all.species, one.species);
  }
  return all;
}

template <int D>
int run_copies(const State<D>& s, std::int64_t steps, int threads, int copies) {
  const jam::EngineSetup<D> setup = copy(s, copies);
  const double before = status_bytes("VmRSS");
  jam::Engine<D> engine(setup);
  engine.set_threads(threads);
  engine.run(steps / 10);
  const double seconds = seconds_of(engine, steps);
  const auto grains = static_cast<double>(engine.grains());
  std::cout << fmt::format(
      "{{\"seconds\": {}, \"kernels\": \"{}\", \"grains\": {}, \"bytes_per_grain\": {:.0f}, \"bytes_per_grain_most\": "
      "{:.0f}}}\n",
      seconds, jam::best_kernels().name, engine.grains(), (status_bytes("VmRSS") - before) / grains,
      (status_bytes("VmHWM") - before) / grains);
  return 0;
}

template <int D>
int run(int argc, char** argv, const State<D>& s) {
  const std::int64_t steps = std::atoll(argv[3]);
  return argc == 6 ? run_copies(s, steps, std::atoi(argv[4]), std::atoi(argv[5])) : run(argv[1], s, steps);
}

}  // namespace

int main(int argc, char** argv) try {
  const bool copies = argc == 6 && std::string(argv[1]) == "copies";
  if (argc != 4 && !copies)
    throw jam::usage_error("usage: engine_bench state|time|schemes FILE STEPS, or copies FILE STEPS THREADS COPIES");
  const jam::FlushToZero flush;  // as every run does
  const std::string path = argv[2];
  std::ifstream in(path);
  const auto value = read_header(in);
  const auto dimension = value.find("dimension");
  if (dimension == value.end()) throw jam::data_error("'dimension' is missing", path, "remove it and run again");
  return dimension->second == 2 ? run(argc, argv, read<2>(in, value, path)) : run(argc, argv, read<3>(in, value, path));
} catch (const std::exception& error) {
  std::cerr << "engine_bench: " << error.what() << "\n";
  return 1;
}
