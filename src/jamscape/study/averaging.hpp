// How the values of the realisations of one state become one number, as each column of a measure says
// (observe/measure.hpp).
#pragma once

#include <vector>

#include "jamscape/observe/measure.hpp"
#include "jamscape/stats/moments.hpp"

namespace jam {

/// Moments of the values that count; values that are not finite never do.
///   mean                of all
///   nonzero_or_missing  of the non-zero ones; nothing (n = 0) where fewer than half are non-zero
///   nonzero_or_zero     of the non-zero ones; 0 without error where at least half are zero
Moments average(std::vector<double> values, Averaging averaging);

/// sum(over)/sum(under) over the realisations, its error by jackknife; sd = se sqrt(n). Realisations in which either is
/// not finite are left out; NaN where sum(under) is 0.
Moments pooled_ratio(const std::vector<double>& over, const std::vector<double>& under);

}  // namespace jam
