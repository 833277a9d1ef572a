// Persistence of contact networks, ours and GUDHI's, complex built and reduced. Each network is checked for equal
// diagrams before it is timed; a network on which they differ is reported as an error.
//
//   persistence_bench                                all sizes, some minutes with GUDHI
//   persistence_bench --benchmark_filter='/2000$'    one
//   persistence_bench --benchmark_format=json        raw numbers
#include <benchmark/benchmark.h>

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "gudhi_diagram.hpp"
#include "jamscape/topology/betti.hpp"
#include "jamscape/topology/persistence.hpp"
#include "networks.hpp"

namespace {

using jam::PersistenceOptions;
using jam::Triangles;

struct Case {
  jam::WeightedGraph graph;
  PersistenceOptions options;
  bool agrees = false;
};

/// The network of a jammed packing: discs with H0 and H1, spheres with H2 also.
const Case& packing(int dimension, std::int64_t grains) {
  static std::map<std::pair<int, std::int64_t>, Case> made;
  const auto [at, is_new] = made.try_emplace({dimension, grains});
  auto& c = at->second;
  if (is_new) {
    c.graph = jam::examples::packing(static_cast<std::uint32_t>(grains), dimension, dimension == 2 ? .86 : .66, 200, 1);
    c.options = {dimension - 1, Triangles::fill, false};
    using namespace jam::examples;
    c.agrees = sorted(points(jam::persistence(c.graph, c.options))) == sorted(gudhi_diagram(c.graph, c.options));
  }
  return c;
}

template <class Run>
void measure(benchmark::State& state, const Case& c, const Run& run) {
  if (!c.agrees) return state.SkipWithError("the diagrams differ");
  for (auto _ : state) benchmark::DoNotOptimize(run());
  state.counters["edges"] = static_cast<double>(c.graph.edges());
  state.counters["time_per_edge"] = benchmark::Counter(
      static_cast<double>(c.graph.edges()),
      benchmark::Counter::Flags(benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert));
}

void jamscape(benchmark::State& state, int dimension) {
  const auto& c = packing(dimension, state.range(0));
  jam::PersistenceWorkspace workspace;
  measure(state, c, [&] { return jam::persistence(c.graph, c.options, workspace); });
}

void jamscape_fresh_memory(benchmark::State& state, int dimension) {
  const auto& c = packing(dimension, state.range(0));
  measure(state, c, [&] { return jam::persistence(c.graph, c.options); });
}

void gudhi(benchmark::State& state, int dimension) {
  const auto& c = packing(dimension, state.range(0));
  measure(state, c, [&] { return jam::examples::gudhi_diagram(c.graph, c.options); });
}

void betti_curves(benchmark::State& state, int dimension) {
  const auto& c = packing(dimension, state.range(0));
  const auto diagram = jam::persistence(c.graph, c.options);
  std::vector<double> grid;
  for (int i = 0; i <= 100; ++i) grid.push_back(.05 * i);
  measure(state, c, [&] {
    std::size_t sum = 0;
    for (int k = 0; k <= c.options.max_dimension; ++k) sum += jam::betti_curve(diagram, k, grid)[1];
    return sum;
  });
}

void discs(benchmark::internal::Benchmark* b) { b->Arg(2000)->Arg(20000)->Arg(100000)->Unit(benchmark::kMillisecond); }
void spheres(benchmark::internal::Benchmark* b) { b->Arg(4096)->Arg(32768)->Unit(benchmark::kMillisecond); }

BENCHMARK_CAPTURE(jamscape, discs, 2)->Apply(discs);
BENCHMARK_CAPTURE(jamscape_fresh_memory, discs, 2)->Apply(discs);
BENCHMARK_CAPTURE(betti_curves, discs, 2)->Apply(discs);
BENCHMARK_CAPTURE(gudhi, discs, 2)->Apply(discs);
BENCHMARK_CAPTURE(jamscape, spheres, 3)->Apply(spheres);
BENCHMARK_CAPTURE(jamscape_fresh_memory, spheres, 3)->Apply(spheres);
BENCHMARK_CAPTURE(betti_curves, spheres, 3)->Apply(spheres);
BENCHMARK_CAPTURE(gudhi, spheres, 3)->Apply(spheres);

}  // namespace

BENCHMARK_MAIN();
