// Star-steps per second of the engine of clusters, one benchmark a kernel: a bed of 2,000 stars, L/d = 5, that has
// settled under gravity between plane walls. All kernels must end in the same bits before any is timed.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>

#include "jamscape/base/random.hpp"
#include "jamscape/dem/cluster_engine.hpp"
#include "jamscape/geometry/cluster_shape.hpp"

namespace {

using namespace jam;

/// Damping ratio .2, friction .5 (walls: none), k_n = m = d = 1: the law of S3 for stars heavier than theirs.
ClusterSetup falling_stars() {
  constexpr int side = 7;
  constexpr double pitch = 5.6;
  ClusterSetup s;
  s.shapes = {star_shape(5)};
  s.density = 1 / s.shapes[0].volume;
  Random random(1, "bench", 0, "start");
  for (int k = 0; k < 2000; ++k) {
    s.bodies.shape.push_back(0);
    s.bodies.position.push_back(
        {(k % side + 0.5) * pitch, (k / side % side + 0.5) * pitch, (k / (side * side) + 0.5) * pitch});
    s.bodies.velocity.push_back(
        {random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02)});
    Quaternion q{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    s.bodies.orientation.push_back(q);
  }
  for (const int axis : {0, 1}) {
    s.walls.push_back({.axis = axis, .high = false, .position = 0});
    s.walls.push_back({.axis = axis, .high = true, .position = side * pitch});
  }
  s.walls.push_back({.axis = 2, .high = false, .position = 0});
  s.gravity = {0, 0, -2e-4};
  s.grain_law = {1, 0.4, 0.5, 0.4 * 0.7071, 2, 0.5, 0.5, 0, false};
  s.wall_law = s.grain_law;
  s.wall_law.mu = 0;
  s.dt = 0.05;
  return s;
}

const Archive& settled() {
  static const Archive state = [] {
    ClusterEngine engine(falling_stars());
    engine.run(80000);
    engine.compute_forces();
    const Packing p = engine.record();
    std::size_t walls = 0;
    for (const auto j : p.contacts.j) walls += j < 0;
    std::printf("settled: %.2f contacts a star between stars, %zu at walls, kinetic energy %.2g of elastic\n",
                static_cast<double>(p.contacts.size() - walls) / 1000.0, walls, p.energy.kinetic / p.energy.elastic);
    engine.advance();
    Archive a;
    engine.save(a);
    return a;
  }();
  return state;
}

void step_stars(benchmark::State& state, const ClusterKernels& kernels) {
  ClusterEngine engine(falling_stars(), kernels);
  engine.load(settled());
  constexpr int steps = 200;
  for (auto _ : state) engine.run(steps);
  state.SetItemsProcessed(state.iterations() * steps * static_cast<std::int64_t>(engine.grains()));
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  Archive expected;
  for (const ClusterKernels* kernels : available_cluster_kernels()) {
    ClusterEngine engine(falling_stars(), *kernels);
    engine.load(settled());
    engine.run(500);
    Archive a;
    engine.save(a);
    if (expected.empty()) expected = a;
    if (a != expected) {
      std::fprintf(stderr, "%s gives other bits than plain\n", kernels->name);
      return EXIT_FAILURE;
    }
    benchmark::RegisterBenchmark(("stars/" + std::string(kernels->name)).c_str(), step_stars, *kernels)
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::RunSpecifiedBenchmarks();
}
