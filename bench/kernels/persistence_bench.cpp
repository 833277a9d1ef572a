// Persistence of contact networks, ours beside GUDHI's: the clique complex built and reduced, H0 and H1 of discs, H2 of
// spheres too. A network is timed only if both give the same diagram. Both go in turns, one after the other, round by
// round.
//
//   persistence_bench [--rounds N] [--json FILE] [NETWORK...]     all networks, 7 rounds: some minutes
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
#include <string>
#include <vector>

#include "gudhi_diagram.hpp"
#include "jamscape/base/error.hpp"
#include "jamscape/topology/betti.hpp"
#include "jamscape/topology/persistence.hpp"
#include "networks.hpp"

namespace {

struct Network {
  const char* name;
  int dimension;
  std::uint32_t grains;
};
constexpr Network networks[] = {{"discs_2000", 2, 2000},
                                {"discs_20000", 2, 20000},
                                {"discs_100000", 2, 100000},
                                {"spheres_4096", 3, 4096},
                                {"spheres_32768", 3, 32768}};

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
  std::vector<double> gudhi, ours, ours_reusing, betti;
};

void write_row(const Network& network, const jam::WeightedGraph& graph, const Times& t) {
  std::vector<double> ratio;
  for (std::size_t k = 0; k < t.gudhi.size(); ++k) ratio.push_back(t.gudhi[k] / t.ours[k]);
  const Spread r = spread(ratio);
  fmt::print("{:<14}{:>8}{:>11.3f}{:>11.3f}{:>10.1f} ({:.1f}-{:.1f}){:>13.3f}{:>15.3f}\n", network.name, graph.edges(),
             spread(t.gudhi).median, spread(t.ours).median, r.median, r.least, r.most, spread(t.ours_reusing).median,
             spread(t.betti).median);
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
  jam::PersistenceWorkspace workspace;
  Times t;
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
  }
  return t;
}

int run(int rounds, const std::string& json, const std::vector<std::string>& wanted) {
  for (const auto& name : wanted)
    if (std::none_of(std::begin(networks), std::end(networks), [&](const Network& n) { return n.name == name; }))
      throw jam::usage_error("no network is called '" + name + "'");
  fmt::print("{} rounds, one core; milliseconds (median), ratio = GUDHI / Jamscape: median (least-most)\n", rounds);
  fmt::print("{:<14}{:>8}{:>11}{:>11}{:>21}{:>13}{:>15}\n", "network", "edges", "GUDHI", "Jamscape", "ratio       ",
             "memory kept", "Betti curves");
  std::string rows;
  for (const Network& network : networks) {
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), network.name) == wanted.end()) continue;
    const auto graph =
        jam::examples::packing(network.grains, network.dimension, network.dimension == 2 ? .86 : .66, 200, 1);
    const Times t = measure(network, graph, rounds);
    write_row(network, graph, t);
    rows += fmt::format(
        "{}\n\"{}\": {{\"edges\": {}, \"gudhi\": {}, \"jamscape\": {}, \"jamscape_memory_kept\": {}, "
        "\"betti_curves\": {}}}",
        rows.empty() ? "" : ",", network.name, graph.edges(), t.gudhi, t.ours, t.ours_reusing, t.betti);
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
