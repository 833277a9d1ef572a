#include "jamscape/topology/total.hpp"

namespace jam {

double total_persistence(const Diagram& diagram, int dimension) {
  double sum = 0;
  for (const auto& p : pairs_of(diagram, dimension)) sum += p.birth - p.death;
  return sum;
}

}  // namespace jam
