#include "jamscape/observe/level_sets.hpp"

#include <algorithm>

#include "jamscape/network/triangles.hpp"
#include "jamscape/observe/entry.hpp"
#include "jamscape/observe/threshold_grid.hpp"
#include "jamscape/topology/betti.hpp"

namespace jam {
namespace {

/// How many values are above each threshold.
std::vector<double> above(std::vector<double> values, const std::vector<double>& thresholds) {
  std::sort(values.begin(), values.end());
  std::vector<double> counts;
  for (const double t : thresholds)
    counts.push_back(
        static_cast<double>(values.end() - std::upper_bound(values.begin(), values.end(), bar(Level::above, t))));
  return counts;
}

std::vector<std::vector<double>> level_sets(const Snapshot& s) {
  std::vector<double> grid = threshold_grid(s.options().level_max, s.options().level_step);
  std::vector<std::vector<double>> columns(4);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto curve = betti_curve(s.diagram(), static_cast<int>(k), grid, Level::above);
    columns[k + 1].assign(curve.begin(), curve.end());
  }
  if (s.options().tetrahedra == Tetrahedra::hollow)
    columns[3] = hollow_voids(s.network().graph, grid, columns[1], columns[2]);
  columns[0] = std::move(grid);

  const auto grains = static_cast<double>(s.packing().grains.size());
  const auto add = [&](const auto& value) {
    std::vector<double>& column = columns.emplace_back(s.levels().size());
    std::transform(s.levels().begin(), s.levels().end(), column.begin(), value);
  };
  const auto part = [](double of, double all) { return all > 0 ? of / all : 0.0; };
  add([](const ClusterLevel& l) { return l.clusters; });
  add([](const ClusterLevel& l) { return l.cluster_vertices; });
  add([&](const ClusterLevel& l) { return part(l.cluster_vertices, grains); });
  add([&](const ClusterLevel& l) { return part(l.cluster_vertices, grains * l.clusters); });
  for (std::size_t a = 0; a < 3; ++a) add([&](const ClusterLevel& l) { return l.percolates[a] ? 1 : 0; });
  add([&](const ClusterLevel& l) { return part(l.percolating_vertices, grains); });
  add([](const ClusterLevel& l) { return l.shape; });
  return columns;
}

}  // namespace

std::vector<double> hollow_voids(const WeightedGraph& graph, const std::vector<double>& thresholds,
                                 const std::vector<double>& b0, const std::vector<double>& b1) {
  std::vector<double> strongest(graph.vertices, 0.0);  // edge of each vertex: its value
  for (std::size_t e = 0; e < graph.edges(); ++e)
    for (const std::uint32_t v : {graph.from[e], graph.to[e]}) strongest[v] = std::max(strongest[v], graph.weight[e]);
  const std::vector<double> vertices = above(std::move(strongest), thresholds), edges = above(graph.weight, thresholds),
                            triangles = above(triangle_weights(graph), thresholds);
  std::vector<double> b2;
  for (std::size_t k = 0; k < thresholds.size(); ++k)
    b2.push_back(vertices[k] - edges[k] + triangles[k] - b0[k] + b1[k]);
  return b2;
}

Measure level_sets_measure() {
  Measure m = rows_measure(
      {"level_sets", "clusters, loops and percolation at each threshold",
       "The network of forces F > F_th, F in mean forces (above: not within 1e-12 of F_th times F_th); F_th = 0, "
       "level_step, "
       "... level_max. b_k = classes of dimension k with death <= F_th < birth, cliques filled (b2: "
       "option tetrahedra; in two dimensions it is 0, also where the triangles of a periodic plane close). A "
       "cluster is a connected piece with an edge; it percolates where it joins two opposite walls (a wall contact of "
       "positive force touches) or winds around a periodic box. <S>/N = (grains in clusters that do not percolate)/(N "
       "clusters), N all grains; S_p = mean over clusters, percolating ones included, of edges/grains: (n - 1)/n for "
       "an open path, 1 for a ring.",
       "S2 Sec. 4.2, 4.3, 5.1, 5.2; theory sec. 4"},
      {{"threshold", "<F>", "F_th"},
       {"b0", "", "pieces with an edge, percolating ones included"},
       {"b1", "", "loops of four contacts or more, those around a periodic box among them"},
       {"b2", "", "voids; 0 in two dimensions where tetrahedra are filled"},
       {"clusters", "", "clusters that do not percolate"},
       {"cluster_grains", "", "grains in clusters that do not percolate"},
       {"cluster_fraction", "", "cluster_grains/N"},
       {"mean_cluster", "", "<S>/N of this frame; 0 without clusters"},
       {"percolating_x", "", "1 where a cluster percolates along x"},
       {"percolating_y", "", "1 where a cluster percolates along y"},
       {"percolating_z", "", "1 where a cluster percolates along z; 0 in two dimensions"},
       {"percolating_grains", "", "N_per/N, grains in percolating clusters; 0 without", Averaging::nonzero_or_missing},
       {"shape", "", "S_p; 0 without clusters", Averaging::nonzero_or_zero}},
      1, true, level_sets);
  m.ratios = {{"mean_cluster_pooled", "cluster_fraction", "clusters",
               "<S>/N over all clusters of all realisations that do not percolate"}};
  return m;
}

}  // namespace jam
