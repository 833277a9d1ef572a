// Persistence of contact networks, ours beside GUDHI's: the clique complex built and reduced, H0 and H1 of discs, H2 of
// spheres too. A network is timed only if both give the same diagram. Both go in turns, one after the other, round by
// round.
//
//   persistence_bench [--rounds N] [--json FILE] [NETWORK...]
//
// 7 rounds; without names the five smaller networks: some minutes. The others take many, most to make them.
//
// Memory is what the call has at most on the heap at a time, its result included, the graph not. The level sweep
// (clusters, percolation, S_p) has 61 thresholds, Betti curves 101; Betti curves are read from a diagram that is there.
//
// Leave the machine alone meanwhile, and quote the ratios.
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <sched.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <span>
#include <string>
#include <vector>

#include "gudhi_diagram.hpp"
#include "heap_peak.hpp"
#include "jamscape/base/error.hpp"
#include "jamscape/network/level_sweep.hpp"
#include "jamscape/topology/betti.hpp"
#include "jamscape/topology/persistence.hpp"
#include "networks.hpp"

namespace {

struct Network {
  const char* name;
  int dimension;
  std::uint32_t grains;
  int steps = 200;  // of the generator; fewer for networks that are measured only when asked for
};
constexpr Network networks[] = {{"discs_2000", 2, 2000},           {"discs_20000", 2, 20000},
                                {"discs_100000", 2, 100000},       {"spheres_4096", 3, 4096},
                                {"spheres_32768", 3, 32768},       {"discs_1000000", 2, 1000000, 60},
                                {"spheres_110592", 3, 110592, 60}, {"spheres_995328", 3, 995328, 30}};

/// Milliseconds of one call, over as many calls as make a twentieth of a second.
template <class Run>
double milliseconds(const Run& run) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  std::chrono::duration<double, std::milli> spent{};
  int calls = 0;
  std::size_t points = 0;
  do {
    points += run();
    ++calls;
    spent = Clock::now() - start;
  } while (spent.count() < 50);
  if (points == 0) throw jam::data_error("an empty diagram");  // and keeps the compiler from leaving the calls out
  return spent.count() / calls;
}

struct Spread {
  double least, median, most;
};
Spread spread(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {values.front(), values[values.size() / 2], values.back()};
}

/// Milliseconds by round.
struct Times {
  std::vector<double> gudhi, ours, ours_reusing, betti, levels;
  double gudhi_bytes = 0, bytes = 0;  // an edge
};

void write_row(const Network& network, const jam::WeightedGraph& graph, const Times& t) {
  std::vector<double> ratio;
  for (std::size_t k = 0; k < t.gudhi.size(); ++k) ratio.push_back(t.gudhi[k] / t.ours[k]);
  const Spread r = spread(ratio);
  fmt::print("{:<14}{:>8}{:>11.3f}{:>11.3f}{:>10.1f} ({:.1f}-{:.1f}){:>13.3f}{:>15.3f}{:>13.3f}{:>14.0f}{:>9.0f}\n",
             network.name, graph.edges(), spread(t.gudhi).median, spread(t.ours).median, r.median, r.least, r.most,
             spread(t.ours_reusing).median, spread(t.betti).median, spread(t.levels).median, t.bytes, t.gudhi_bytes);
  std::cout.flush();
}

Times measure(const Network& network, const jam::WeightedGraph& graph, int rounds) {
  using namespace jam::examples;
  const jam::PersistenceOptions options{network.dimension - 1, jam::Triangles::fill, false};
  const auto diagram = jam::persistence(graph, options);
  if (sorted(points(diagram)) != sorted(gudhi_diagram(graph, options)))
    throw jam::data_error(fmt::format("the diagrams of {} differ", network.name));
  std::vector<double> grid;
  for (int i = 0; i <= 100; ++i) grid.push_back(.05 * i);
  const std::span<const double> level_grid = std::span(grid).first(61);
  jam::PersistenceWorkspace workspace;
  Times t;
  const auto edges = static_cast<double>(graph.edges());
  t.bytes = heap_peak([&] { jam::persistence(graph, options); }) / edges;
  t.gudhi_bytes = heap_peak([&] { gudhi_diagram(graph, options); }) / edges;
  for (int round = 0; round < rounds; ++round) {
    t.gudhi.push_back(milliseconds([&] { return gudhi_diagram(graph, options).size(); }));
    t.ours.push_back(milliseconds([&] { return points(jam::persistence(graph, options)).size(); }));
    t.ours_reusing.push_back(milliseconds([&] { return points(jam::persistence(graph, options, workspace)).size(); }));
    t.betti.push_back(milliseconds([&] {
      std::size_t sum = 0;
      for (int k = 0; k < network.dimension; ++k)
        sum += static_cast<std::size_t>(jam::betti_curve(diagram, k, grid)[0]) + 1;
      return sum;
    }));
    t.levels.push_back(milliseconds([&] { return jam::level_sweep(graph, level_grid).size(); }));
  }
  return t;
}

int run(int rounds, const std::string& json, const std::vector<std::string>& wanted) {
  for (const auto& name : wanted)
    if (std::none_of(std::begin(networks), std::end(networks), [&](const Network& n) { return n.name == name; }))
      throw jam::usage_error("no network is called '" + name + "'");
  fmt::print("{} rounds, one core; milliseconds (median), ratio = GUDHI / Jamscape: median (least-most)\n", rounds);
  fmt::print("{:<14}{:>8}{:>11}{:>11}{:>21}{:>13}{:>15}{:>13}{:>14}{:>9}\n", "network", "edges", "GUDHI", "Jamscape",
             "ratio       ", "memory kept", "Betti curves", "level sweep", "bytes an edge", "GUDHI's");
  std::string rows;
  for (const Network& network : networks) {
    const bool asked = std::find(wanted.begin(), wanted.end(), network.name) != wanted.end();
    if (wanted.empty() ? network.steps < 200 : !asked) continue;
    const auto graph =
        jam::examples::packing(network.grains, network.dimension, network.dimension == 2 ? .86 : .66, network.steps, 1);
    const Times t = measure(network, graph, rounds);
    write_row(network, graph, t);
    rows += fmt::format(
        "{}\n\"{}\": {{\"edges\": {}, \"gudhi\": {}, \"jamscape\": {}, \"jamscape_memory_kept\": {}, "
        "\"betti_curves\": {}, \"level_sweep\": {}, \"bytes_per_edge\": {}, \"gudhi_bytes_per_edge\": {}}}",
        rows.empty() ? "" : ",", network.name, graph.edges(), t.gudhi, t.ours, t.ours_reusing, t.betti, t.levels,
        t.bytes, t.gudhi_bytes);
  }
  if (!json.empty()) std::ofstream(json) << "{" << rows << "\n}\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  int rounds = 7;
  std::string json;
  std::vector<std::string> wanted;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    if (word == "--rounds" && k + 1 < argc)
      rounds = std::max(1, std::atoi(argv[++k]));
    else if (word == "--json" && k + 1 < argc)
      json = argv[++k];
    else
      wanted.push_back(word);
  }
  cpu_set_t cores;  // stay on one core
  CPU_ZERO(&cores);
  CPU_SET(static_cast<std::size_t>(sched_getcpu()), &cores);
  sched_setaffinity(0, sizeof cores, &cores);
  return run(rounds, json, wanted);
} catch (const std::exception& error) {
  std::cerr << "persistence_bench: " << error.what() << "\n";
  return 1;
}
