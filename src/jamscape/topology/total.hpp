// Total persistence: TP_k = sum of birth - death over the points of dimension k, essential ones (death 0) included.
// S2 Sec. 5; divide by the number of grains to compare systems (theory sec. 4).
#pragma once

#include "jamscape/topology/persistence.hpp"

namespace jam {

/// In the unit of the weights. Summed in the order of the pairs.
double total_persistence(const Diagram& diagram, int dimension);

}  // namespace jam
