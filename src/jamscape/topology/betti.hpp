// Betti numbers from a diagram: how many components (b0), loops (b1), voids (b2), ... the level set at theta has.
//
// Level::at_least (S1) holds every cell with value >= theta, so a class counts for death < theta <= birth: present at
// its birth, gone at its death. Level::above (S2) holds those with value > theta: death <= theta < birth. An essential
// class has no death that ends it, at theta = 0 neither. A value on theta to within round-off equals it (level.hpp). An
// isolated vertex has value 0: it counts for theta <= 0 (at_least) or theta < 0 (above) only. A force network's b1 at
// theta = 0 is therefore the number of its essential loops.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "jamscape/network/level.hpp"
#include "jamscape/topology/persistence.hpp"

namespace jam {

std::size_t betti(const Diagram& diagram, int dimension, double threshold, Level level = Level::at_least);

/// The same at many thresholds, in any order, by one pass over the pairs.
std::vector<std::size_t> betti_curve(const Diagram& diagram, int dimension, std::span<const double> thresholds,
                                     Level level = Level::at_least);

}  // namespace jam
