// Betti numbers from a diagram: how many components (b0), loops (b1), voids (b2), ... the level set at theta has.
//
// The level set holds every cell with value >= theta, so a class counts for death < theta <= birth: present at its
// birth, gone at its death. An essential class counts for every theta <= birth. An isolated vertex has value 0: it
// counts for theta <= 0 only. A force-network's b1 at theta = 0 is therefore the number of its essential loops.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "jamscape/topology/persistence.hpp"

namespace jam {

std::size_t betti(const Diagram& diagram, int dimension, double threshold);

/// The same at many thresholds, in any order, by one sort of births and deaths.
std::vector<std::size_t> betti_curve(const Diagram& diagram, int dimension, std::span<const double> thresholds);

}  // namespace jam
