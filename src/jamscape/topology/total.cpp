#include "jamscape/topology/total.hpp"

namespace jam {

double total_persistence(const Diagram& diagram, int dimension) {
  double sum = 0;
  for (const auto& p : diagram.pairs) {
    if (p.dimension == dimension) sum += p.birth - p.death;
  }
  return sum;
}

}  // namespace jam
