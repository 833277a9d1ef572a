#include "jamscape/topology/bins.hpp"

namespace jam {

BinCounts persistence_bins(const Diagram& diagram, int dimension, const BinOptions& options) {
  BinCounts count;
  for (const auto& p : pairs_of(diagram, dimension)) {
    const bool isolated = dimension == 0 && p.essential && p.birth == 0;
    const double life = p.birth - p.death;
    if (life == 0 && !isolated) continue;
    const bool rough = options.edge == RoughEdge::open ? life < options.rough : life <= options.rough;
    ++(rough                       ? count.rough
       : p.birth >= options.strong ? count.strong
       : p.birth >= options.medium ? count.medium
                                   : count.weak);
  }
  return count;
}

}  // namespace jam
