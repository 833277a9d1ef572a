// Does the whole force network (F > 0) join opposite sides of the box, and what a random network would need for it.
//
//   p_c = <k>/(<k^2> - <k>)     k contacts of a grain in the network; the fraction of vertices that percolation needs
//   in
//                               a random network of these degrees: .5 where all k = 3, .2 where all k = 6
//
// p_c does not depend on how many grains have no contact. Source: S2 Eq. 6 and Sec. 4.3; theory sec. 4.
#pragma once

#include <vector>

#include "jamscape/observe/measure.hpp"

namespace jam {

/// NaN where no vertex has two edges or more.
double percolation_estimate(const std::vector<std::uint32_t>& degree);

Measure percolation_measure();

}  // namespace jam
