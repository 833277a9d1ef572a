// Our diagrams against GUDHI's: the same points, all dimensions, exactly.
#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>
#include <string>

#include "gudhi_diagram.hpp"
#include "jamscape/topology/betti.hpp"
#include "jamscape/topology/persistence.hpp"
#include "networks.hpp"
#include "read_network.hpp"

namespace jam::examples {
namespace {

/// Networks that differ by seed.
struct Family {
  const char* name;
  int networks;
  int max_dimension;
  WeightedGraph (*make)(std::uint64_t seed);
  Triangles triangles = Triangles::fill;

  friend std::ostream& operator<<(std::ostream& out, const Family& f) { return out << f.name; }
};

class Gudhi : public testing::TestWithParam<Family> {};

void expect_same(const WeightedGraph& graph, const PersistenceOptions& options) {
  const auto ours = sorted(points(persistence(graph, options))), theirs = sorted(gudhi_diagram(graph, options));
  ASSERT_EQ(ours.size(), theirs.size());
  for (std::size_t i = 0; i < ours.size(); ++i) ASSERT_EQ(ours[i], theirs[i]) << "point " << i;
}

TEST_P(Gudhi, gives_the_same_points) {
  const auto& family = GetParam();
  for (int seed = 0; seed < family.networks; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    expect_same(family.make(static_cast<std::uint64_t>(seed)), {family.max_dimension, family.triangles, false});
    if (HasFatalFailure()) return;
  }
}

std::uint32_t size(std::uint64_t seed, std::uint32_t from, std::uint32_t step) {
  return from + step * static_cast<std::uint32_t>(seed);
}

INSTANTIATE_TEST_SUITE_P(
    networks, Gudhi,
    testing::Values(
        Family{"geometric_2d", 20, 1, [](auto s) { return geometric(size(s, 20, 40), 2, .09, forces(), s); }},
        Family{"geometric_2d_ties", 15, 2, [](auto s) { return geometric(size(s, 20, 25), 2, .11, levels(5), s); }},
        Family{"geometric_3d", 15, 2, [](auto s) { return geometric(size(s, 20, 25), 3, .22, forces(), s); }},
        Family{"geometric_3d_ties", 15, 2, [](auto s) { return geometric(size(s, 20, 25), 3, .22, levels(4), s); }},
        Family{"geometric_3d_to_h3", 8, 3, [](auto s) { return geometric(size(s, 20, 15), 3, .3, forces(), s); }},
        Family{"sparse_pieces", 15, 2,
               [](auto s) { return shuffled(geometric(size(s, 20, 20), 2, .05, forces(), s), 17, s); }},
        Family{"erdos_renyi_sparse", 15, 2, [](auto s) { return erdos_renyi(size(s, 20, 15), .02, forces(), s); }},
        Family{"erdos_renyi_dense", 15, 2, [](auto s) { return erdos_renyi(size(s, 4, 2), .6, forces(), s); }},
        Family{"erdos_renyi_dense_ties", 15, 3, [](auto s) { return erdos_renyi(size(s, 4, 1), .7, levels(4), s); }},
        Family{"erdos_renyi_to_h4", 6, 4, [](auto s) { return erdos_renyi(size(s, 10, 2), .6, forces(), s); }},
        Family{"hubs", 4, 1, [](auto s) { return erdos_renyi(size(s, 70, 10), .6, forces(), s); }},
        Family{"square", 6, 1, [](auto s) { return lattice(Lattice::square, size(s, 9, 60), .9, forces(), s); }},
        Family{"square_ties", 6, 1, [](auto s) { return lattice(Lattice::square, size(s, 9, 60), 1, levels(3), s); }},
        Family{"triangular", 8, 2, [](auto s) { return lattice(Lattice::triangular, size(s, 9, 70), 1, forces(), s); }},
        Family{"triangular_ties", 8, 2,
               [](auto s) { return lattice(Lattice::triangular, size(s, 9, 70), .95, levels(3), s); }},
        Family{"triangular_all_equal", 3, 2,
               [](auto s) {
                 return lattice(
                     Lattice::triangular, size(s, 9, 70), 1, [](Random&) { return 1.; }, s);
               }},
        Family{"honeycomb", 6, 1, [](auto s) { return lattice(Lattice::honeycomb, size(s, 30, 60), .9, forces(), s); }},
        Family{"cubic", 5, 2, [](auto s) { return lattice(Lattice::cubic, size(s, 27, 80), .9, forces(), s); }},
        Family{"fcc", 8, 2, [](auto s) { return lattice(Lattice::fcc, size(s, 60, 60), .95, forces(), s); }},
        Family{"fcc_ties", 8, 3, [](auto s) { return lattice(Lattice::fcc, size(s, 60, 60), 1, levels(3), s); }},
        Family{"disc_packing", 10, 1,
               [](auto s) { return packing(size(s, 100, 60), 2, .8 + .01 * double(s), 150, s); }},
        Family{"disc_packing_clamped", 5, 2,
               [](auto s) { return clamped(packing(size(s, 100, 60), 2, .9, 100, s), 1.5); }},
        Family{"sphere_packing", 8, 2,
               [](auto s) { return packing(size(s, 100, 60), 3, .6 + .02 * double(s), 100, s); }},
        Family{"two_packings_apart", 4, 2,
               [](auto s) {
                 return shuffled(side_by_side(packing(150, 2, .86, 100, s), packing(150, 3, .68, 80, s)), 9, s);
               }},
        Family{"loops_of_three_kept", 8, 1, [](auto s) { return geometric(size(s, 20, 30), 2, .12, levels(6), s); },
               Triangles::keep},
        Family{"components_only", 8, 0, [](auto s) { return geometric(size(s, 20, 30), 2, .1, levels(9), s); }}),
    [](const auto& family) { return std::string(family.param.name); });

TEST(GudhiOnFiles, gives_the_same_points) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(JAM_NETWORKS)) {
    const auto name = entry.path().filename().string();
    if (!name.ends_with(".csv") && !name.ends_with(".csv.gz")) continue;
    SCOPED_TRACE(name);
    const auto graph = read_network(entry.path());
    for (const int dimension : {0, 1, 2}) expect_same(graph, {dimension, Triangles::fill, false});
    ++files;
  }
  EXPECT_GT(files, 0);
}

TEST(GudhiOnFiles, gives_the_same_betti_numbers_at_each_threshold) {
  int voids = 0;
  for (const auto& entry : std::filesystem::directory_iterator(JAM_NETWORKS)) {
    const auto name = entry.path().filename().string();
    if (name.find("sphere") == std::string::npos) continue;
    SCOPED_TRACE(name);
    const auto graph = read_network(entry.path());
    const auto diagram = persistence(graph, {.max_dimension = 2});
    std::vector<double> grid;
    for (int k = 0; k <= 30; ++k) grid.push_back(.1 * k);
    for (const int dimension : {0, 1, 2}) {
      const auto curve = betti_curve(diagram, dimension, grid, Level::above);
      for (std::size_t k = 0; k < grid.size(); ++k) {
        const auto theirs = gudhi_betti_above(graph, grid[k], 2)[static_cast<std::size_t>(dimension)];
        ASSERT_EQ(curve[k], static_cast<std::size_t>(theirs)) << "dimension " << dimension << ", above " << grid[k];
        voids += dimension == 2 ? theirs : 0;
      }
    }
  }
  EXPECT_GT(voids, 0);
}

}  // namespace
}  // namespace jam::examples
