#include "jamscape/observe/persistence_measures.hpp"

#include <algorithm>

#include "jamscape/observe/entry.hpp"
#include "jamscape/observe/threshold_grid.hpp"
#include "jamscape/topology/betti.hpp"
#include "jamscape/topology/bins.hpp"
#include "jamscape/topology/total.hpp"

namespace jam {

BinOptions bin_options(const MeasureOptions& options) {
  BinOptions bins;
  bins.edge = options.rough_includes_edge ? RoughEdge::closed : RoughEdge::open;
  return bins;
}

Measure persistence_bins_measure() {
  return frame_measure(
      {"persistence_bins", "points of the persistence diagrams by strength",
       "N_k^*: points (b, d) of dimension k that are rough (b - d < 0.1 in S1; <= 0.1 in S2, option "
       "rough_includes_edge), else strong (b >= 2.5), "
       "medium (1 <= b < 2.5) or "
       "weak (b < 1), forces in <F>. Essential classes die at 0; pairs of zero length count only as "
       "isolated grains, (0, 0) of dimension 0, which are rough; removed rattlers (remove_rattlers) are no vertices and "
       "have no point. What is on a border to 1e-12 of the birth is on it.",
       "S1 Sec. II.C, Figs. 5, 6; S2 Sec. 5.3; theory sec. 4"},
      {{"b0_rough", "", "components: short-lived, isolated grains among them"},
       {"b0_strong", "", "components born at 2.5 <F> or more"},
       {"b0_medium", "", "components born between <F> and 2.5 <F>"},
       {"b0_weak", "", "components born below <F>"},
       {"b1_rough", "", "loops: short-lived"},
       {"b1_strong", "", "loops born at 2.5 <F> or more"},
       {"b1_medium", "", "loops born between <F> and 2.5 <F>"},
       {"b1_weak", "", "loops born below <F>"}},
      [](const Snapshot& s) {
        const BinOptions bins = bin_options(s.options());
        std::vector<double> row;
        for (const int dimension : {0, 1}) {
          const BinCounts b = persistence_bins(s.diagram(), dimension, bins);
          for (const std::size_t n : {b.rough, b.strong, b.medium, b.weak}) row.push_back(static_cast<double>(n));
        }
        return row;
      });
}

Measure total_persistence_measure() {
  return frame_measure(
      {"total_persistence", "total persistence",
       "TP_k = sum of birth - death over the points of dimension k, essential classes included (death 0); "
       "divide by the number of grains to compare systems",
       "S2 Sec. 5; theory sec. 4"},
      {{"tp0", "<F>", "of the components"},
       {"tp1", "<F>", "of the loops"},
       {"tp2", "<F>", "of the voids; 0 in two dimensions"}},
      [](const Snapshot& s) {
        std::vector<double> row;
        for (const int dimension : {0, 1, 2}) row.push_back(total_persistence(s.diagram(), dimension));
        return row;
      });
}

Measure betti_measure() {
  return rows_measure(
      {"betti", "Betti numbers",
       "b_k(theta) = classes of dimension k with death < theta <= birth, components, loops and voids of the network of "
       "forces f >= theta, cliques filled; a class that never dies counts at every theta <= birth, theta = 0 among "
       "them. "
       "A value within 1e-12 of theta (times theta) is on it. An isolated grain has value 0 and counts at theta = 0 "
       "only; removed rattlers (remove_rattlers) have none. theta = 0, betti_step, ... betti_max. In a periodic box loops that "
       "wind around it count; copies of a grain are one vertex. In two dimensions b2 is not computed and 0.",
       "S1 App. B; theory sec. 4"},
      {{"threshold", "<F>", "theta"},
       {"b0", "", "components"},
       {"b1", "", "loops of four contacts or more, those around a periodic box among them"},
       {"b2", "", "voids; 0 in two dimensions"}},
      1, true, [](const Snapshot& s) -> std::vector<std::vector<double>> {
        const std::vector<double> grid = threshold_grid(s.options().betti_max, s.options().betti_step);
        std::vector<std::vector<double>> columns{grid};
        for (const int dimension : {0, 1, 2}) {
          const auto curve = betti_curve(s.diagram(), dimension, grid);
          columns.emplace_back(curve.begin(), curve.end());
        }
        return columns;
      });
}

Measure diagram_measure() {
  return rows_measure(
      {"diagram", "persistence diagrams",
       "points (birth, death) of the superlevel filtration of the force network's clique complex: a class is born at "
       "the "
       "largest threshold where it is there and dies at a smaller one; essential classes never die and have death 0.",
       "S1 Sec. II.B, App. B; theory sec. 4"},
      {{"dimension", "", "0 components, 1 loops, 2 voids"},
       {"birth", "<F>", "threshold at which the class appears"},
       {"death", "<F>", "threshold at which it is gone"},
       {"essential", "", "1 where it never dies"}},
      0, false, [](const Snapshot& s) -> std::vector<std::vector<double>> {
        const auto& pairs = s.diagram().pairs;
        const auto column = [&](const auto& value) {
          std::vector<double> numbers(pairs.size());
          std::transform(pairs.begin(), pairs.end(), numbers.begin(), value);
          return numbers;
        };
        return {column([](const PersistencePair& p) { return p.dimension; }),
                column([](const PersistencePair& p) { return p.birth; }),
                column([](const PersistencePair& p) { return p.death; }),
                column([](const PersistencePair& p) { return p.essential ? 1 : 0; })};
      });
}

}  // namespace jam
