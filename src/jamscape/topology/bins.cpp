#include "jamscape/topology/bins.hpp"

#include "jamscape/base/border.hpp"

namespace jam {

BinCounts persistence_bins(const Diagram& diagram, int dimension, const BinOptions& options) {
  BinCounts count;
  const bool closed = options.edge == RoughEdge::closed;
  const double strong = on_from(options.strong), medium = on_from(options.medium);
  for (const auto& p : pairs_of(diagram, dimension)) {
    const bool isolated = dimension == 0 && p.essential && p.birth == 0;
    const double life = p.birth - p.death;
    if (!exceeds(life, 0, p.birth) && !isolated) continue;
    const bool rough = closed ? !exceeds(life, options.rough, p.birth) : !reaches(life, options.rough, p.birth);
    ++(rough ? count.rough : p.birth >= strong ? count.strong : p.birth >= medium ? count.medium : count.weak);
  }
  return count;
}

}  // namespace jam
