// Our side of bench/peers/run_engine for stars: a bed of stars, L/d = 5, that has settled under gravity between plane
// walls. Linear unclipped law, so that LAMMPS has the same; k_n = m = d = 1.
//
//   stars_bench start                  JSON: the setup and the bodies before they fall
//   stars_bench settle ARCHIVE         drops and settles them, and keeps the bed
//   stars_bench state ARCHIVE          JSON: what they weigh on each other
//   stars_bench time ARCHIVE STEPS     JSON: seconds of the stepping loop alone
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "jamscape/base/error.hpp"
#include "jamscape/base/random.hpp"
#include "jamscape/dem/cluster_engine.hpp"
#include "jamscape/geometry/cluster_shape.hpp"
#include "jamscape/io/archive_file.hpp"

namespace {

using namespace jam;

constexpr int stars = 2000, columns = 7;  // dropped from `columns` x `columns` sites a layer
constexpr double aspect = 5, pitch = 5.6, side = columns * pitch;
constexpr double gravity = 2e-4;
constexpr double gamma_n = 0.566, gamma_t = gamma_n / 2;  // damping ratio .2 for two free bodies
constexpr double k_t = 0.5, mu = 0.5, dt = 0.05;
constexpr std::int64_t settling = 100000;  // steps
constexpr std::size_t floor_wall = 4;

/// The walls have no friction.
ClusterSetup falling_stars() {
  constexpr double unclipped = -std::numeric_limits<double>::infinity();
  ClusterSetup s;
  s.shapes = {star_shape(aspect)};
  s.density = 1 / s.shapes[0].volume;
  Random random(1, "stars", 0, "start");
  for (int k = 0; k < stars; ++k) {
    s.bodies.shape.push_back(0);
    s.bodies.scale.push_back(1);
    s.bodies.position.push_back(
        {(k % columns + 0.5) * pitch, (k / columns % columns + 0.5) * pitch, (k / (columns * columns) + 0.5) * pitch});
    s.bodies.velocity.push_back(
        {random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02)});
    s.bodies.spin.push_back({});
    s.bodies.orientation.push_back(
        normalized({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}));
  }
  for (const int axis : {0, 1}) {
    s.walls.push_back({.axis = axis, .high = false, .position = 0});
    s.walls.push_back({.axis = axis, .high = true, .position = side});
  }
  s.walls.push_back({.axis = 2, .high = false, .position = 0});
  s.gravity = {0, 0, -gravity};
  s.kind = NormalLaw::linear;
  s.grain_law = {1, gamma_n, k_t, gamma_t, 1 / k_t, mu, 0, unclipped, false};
  s.wall_law = s.grain_law;
  s.wall_law.mu = 0;
  s.dt = dt;
  return s;
}

ClusterEngine settled(const std::string& path) {
  ClusterEngine engine(falling_stars());
  engine.load(read_archive(path));
  return engine;
}

std::string start() {
  const ClusterSetup s = falling_stars();
  std::string bodies;
  for (std::size_t k = 0; k < s.bodies.size(); ++k) {
    const Vec3 &x = s.bodies.position[k], &v = s.bodies.velocity[k];
    const Quaternion& q = s.bodies.orientation[k];
    bodies += fmt::format("{}[{},{},{},{},{},{},{},{},{},{}]", k == 0 ? "" : ",\n", x[0], x[1], x[2], q.w, q.x, q.y,
                          q.z, v[0], v[1], v[2]);
  }
  return fmt::format(
      "{{\"aspect\": {}, \"side\": {}, \"gravity\": {}, \"dt\": {}, \"k_n\": {}, \"k_t\": {}, \"gamma_n\": {}, "
      "\"gamma_t\": {}, \"mu\": {}, \"settling\": {}, \"inertia\": {},\n\"bodies\": [{}]}}\n",
      aspect, side, gravity, dt, s.grain_law.k_n, k_t, gamma_n, gamma_t, mu, settling,
      s.shapes[0].inertia[0] / s.shapes[0].volume, bodies);
}

std::string state(const std::string& path) {
  ClusterEngine engine = settled(path);
  engine.compute_forces();
  const Packing p = engine.record();
  std::map<std::pair<std::uint32_t, std::int32_t>, Vec3> force;  // of body pairs
  std::size_t contacts = 0;
  for (std::size_t c = 0; c < p.contacts.size(); ++c) {
    if (p.contacts.j[c] < 0) continue;
    ++contacts;
    force[{p.contacts.i[c], p.contacts.j[c]}] +=
        (-p.contacts.normal_force[c]) * p.contacts.normal[c] + p.contacts.tangential_force[c];
  }
  double sum = 0;
  for (const auto& [pair, f] : force) sum += norm(f);
  return fmt::format(
      "{{\"floor_over_weight\": {}, \"contacts\": {}, \"pairs\": {}, \"mean_pair_force\": {}, \"height\": {}, "
      "\"kinetic\": {}}}\n",
      std::abs(engine.wall_force(floor_wall)[2]) / (stars * gravity), contacts, force.size(),
      sum / static_cast<double>(force.size()), engine.highest(2), p.energy.kinetic);
}

int run(const std::string& mode, const std::string& path, std::int64_t steps) {
  if (mode == "start") {
    std::cout << start();
  } else if (mode == "settle") {
    ClusterEngine engine(falling_stars());
    engine.run(settling);
    Archive archive;
    engine.save(archive);
    write_archive(path, archive);
  } else if (mode == "state") {
    std::cout << state(path);
  } else if (mode == "time" && steps > 0) {
    ClusterEngine engine = settled(path);
    const auto start = std::chrono::steady_clock::now();
    engine.run(steps);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::cout << fmt::format("{{\"seconds\": {}, \"kernels\": \"{}\"}}\n", seconds.count(),
                             best_cluster_kernels().name);
  } else {
    throw usage_error("the mode is start, settle, state or time (and steps)");
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2) throw usage_error("usage: stars_bench start | settle ARCHIVE | state ARCHIVE | time ARCHIVE STEPS");
  return run(argv[1], argc > 2 ? argv[2] : "", argc > 3 ? std::atoll(argv[3]) : 0);
} catch (const std::exception& error) {
  std::cerr << "stars_bench: " << error.what() << "\n";
  return 1;
}
