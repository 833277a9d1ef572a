#include "jamscape/observe/persistence_measures.hpp"

#include <cmath>

#include "jamscape/observe/entry.hpp"
#include "jamscape/topology/betti.hpp"
#include "jamscape/topology/bins.hpp"
#include "jamscape/topology/total.hpp"

namespace jam {

std::vector<double> threshold_grid(double max, double step) {
  std::vector<double> grid;
  for (std::size_t k = 0, n = static_cast<std::size_t>(std::floor(max / step + 1e-9)); k <= n; ++k) {
    // Through whole numbers where possible, so that the 7th of .05 is .35 and not .35000000000000003.
    const double per_unit = std::round(1 / step), i = static_cast<double>(k);
    grid.push_back(std::abs(per_unit * step - 1) < 1e-12 ? i / per_unit : i * step);
  }
  return grid;
}

Measure persistence_bins_measure() {
  return frame_measure({"persistence_bins", "points of the persistence diagrams by strength",
                        "N_k^*: points (b, d) of dimension k that are rough (b - d < 0.1), else strong (b >= 2.5), "
                        "medium (1 <= b < 2.5) or "
                        "weak (b < 1), forces in <F>. Essential classes die at 0; pairs of zero length count only as "
                        "isolated grains, which "
                        "are rough.",
                        "S1 Sec. II.C, Figs. 5, 6; theory sec. 4"},
                       {{"b0_rough", "", "components: short-lived, isolated grains among them"},
                        {"b0_strong", "", "components born at 2.5 <F> or more"},
                        {"b0_medium", "", "components born between <F> and 2.5 <F>"},
                        {"b0_weak", "", "components born below <F>"},
                        {"b1_rough", "", "loops: short-lived"},
                        {"b1_strong", "", "loops born at 2.5 <F> or more"},
                        {"b1_medium", "", "loops born between <F> and 2.5 <F>"},
                        {"b1_weak", "", "loops born below <F>"}},
                       [](const Snapshot& s) {
                         std::vector<double> row;
                         for (const int dimension : {0, 1}) {
                           const BinCounts b = persistence_bins(s.diagram(), dimension);
                           for (const std::size_t n : {b.rough, b.strong, b.medium, b.weak})
                             row.push_back(static_cast<double>(n));
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
      {{"tp0", "<F>", "of the components"}, {"tp1", "<F>", "of the loops"}}, [](const Snapshot& s) {
        return std::vector<double>{total_persistence(s.diagram(), 0), total_persistence(s.diagram(), 1)};
      });
}

Measure betti_measure() {
  return rows_measure(
      {"betti", "Betti numbers",
       "b_k(theta) = classes of dimension k with death < theta <= birth: components and loops of the network of forces "
       "f >= theta, triangles filled. An isolated grain has value 0 and counts at theta = 0 only.",
       "S1 App. B; theory sec. 4"},
      {{"threshold", "<F>", "theta"}, {"b0", "", "components"}, {"b1", "", "loops of four contacts or more"}}, 1, true,
      [](const Snapshot& s) -> std::vector<std::vector<double>> {
        std::vector<double> grid = threshold_grid(s.options().betti_max, s.options().betti_step);
        const auto b0 = betti_curve(s.diagram(), 0, grid), b1 = betti_curve(s.diagram(), 1, grid);
        return {std::move(grid), {b0.begin(), b0.end()}, {b1.begin(), b1.end()}};
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
      0, false, [](const Snapshot& s) {
        std::vector<std::vector<double>> rows(4);
        for (const PersistencePair& p : s.diagram().pairs) {
          rows[0].push_back(p.dimension);
          rows[1].push_back(p.birth);
          rows[2].push_back(p.death);
          rows[3].push_back(p.essential ? 1 : 0);
        }
        return rows;
      });
}

}  // namespace jam
