// The same diagrams by GUDHI (Maria et al. 2014): its complexes grow with the value, so cells enter at minus ours;
// vertex values are given, cliques get theirs by expansion. Classes of the last dimension must be asked for, else the
// loops of a network without triangles are missing.
#pragma once

// GUDHI 3.7 uses std::cout without including it.
// clang-format off
#include <iostream>
#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>
// clang-format on

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include "jamscape/topology/persistence.hpp"

namespace jam::examples {

/// dimension, birth, death, essential; zero-length pairs left out, essential classes die at 0.
using Point = std::tuple<int, double, double, bool>;

/// GUDHI's options for fast persistence, but with double values.
struct GudhiOptions : Gudhi::Simplex_tree_options_fast_persistence {
  using Filtration_value = double;
};

inline std::vector<Point> gudhi_diagram(const WeightedGraph& graph, const PersistenceOptions& options = {}) {
  using Tree = Gudhi::Simplex_tree<GudhiOptions>;
  using Cohomology = Gudhi::persistent_cohomology::Persistent_cohomology<Tree, Gudhi::persistent_cohomology::Field_Zp>;
  std::vector<double> value(graph.vertices, 0);
  for (std::size_t e = 0; e < graph.edges(); ++e) {
    for (const auto v : {graph.from[e], graph.to[e]}) value[v] = std::max(value[v], graph.weight[e]);
  }
  Tree tree;
  const auto vertex = [](std::uint32_t v) { return static_cast<Tree::Vertex_handle>(v); };
  for (std::uint32_t v = 0; v < graph.vertices; ++v) tree.insert_simplex(std::array{vertex(v)}, -value[v]);
  for (std::size_t e = 0; e < graph.edges(); ++e) {
    tree.insert_simplex(std::array{vertex(graph.from[e]), vertex(graph.to[e])}, -graph.weight[e]);
  }
  if (options.triangles == Triangles::fill) tree.expansion(options.max_dimension + 1);

  Cohomology cohomology(tree, true);
  cohomology.init_coefficients(2);
  cohomology.compute_persistent_cohomology(0);
  std::vector<Point> points;
  for (const auto& [birth, death, field] : cohomology.get_persistent_pairs()) {
    const int dimension = tree.dimension(birth);
    if (dimension > options.max_dimension) continue;
    const bool essential = death == tree.null_simplex();
    points.emplace_back(dimension, -tree.filtration(birth), essential ? 0 : -tree.filtration(death), essential);
  }
  return points;
}

/// Betti numbers 0..max_dimension of the clique complex of the edges above a threshold and their ends, nothing else
/// known of the rest: one complex for each threshold.
inline std::vector<int> gudhi_betti_above(const WeightedGraph& graph, double threshold, int max_dimension) {
  using Tree = Gudhi::Simplex_tree<GudhiOptions>;
  using Cohomology = Gudhi::persistent_cohomology::Persistent_cohomology<Tree, Gudhi::persistent_cohomology::Field_Zp>;
  std::vector<int> betti(static_cast<std::size_t>(max_dimension) + 1, 0);
  Tree tree;
  std::vector<Tree::Vertex_handle> number(graph.vertices, -1);  // GUDHI wants them without gaps
  Tree::Vertex_handle next = 0;
  const auto vertex = [&](std::uint32_t v) { return number[v] < 0 ? number[v] = next++ : number[v]; };
  for (std::size_t e = 0; e < graph.edges(); ++e) {
    if (!(graph.weight[e] > threshold)) continue;
    for (const auto v : {graph.from[e], graph.to[e]}) tree.insert_simplex(std::array{vertex(v)}, 0.);
    tree.insert_simplex(std::array{vertex(graph.from[e]), vertex(graph.to[e])}, 0.);
  }
  if (tree.num_vertices() == 0) return betti;
  tree.expansion(max_dimension + 1);
  Cohomology cohomology(tree, true);
  cohomology.init_coefficients(2);
  cohomology.compute_persistent_cohomology(0);
  for (int k = 0; k <= max_dimension; ++k) betti[static_cast<std::size_t>(k)] = cohomology.betti_number(k);
  return betti;
}

inline std::vector<Point> points(const Diagram& diagram) {
  std::vector<Point> points;
  for (const auto& p : diagram.pairs) points.emplace_back(p.dimension, p.birth, p.death, p.essential);
  return points;
}

/// A multiset, for comparison.
inline std::vector<Point> sorted(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  return points;
}

}  // namespace jam::examples
