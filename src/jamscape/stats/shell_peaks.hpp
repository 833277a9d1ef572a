// Shells of neighbours: the first three peaks of a radial distribution g(r) = pairs/ideal, pairs the counted ones and
// ideal what an ideal gas has in the same bins. Both add up over particles and over realisations.
//
// g is smoothed over 3 bins. Peak 1 is its maximum, at r_1; peak 2 its maximum within 1.5 to 2.5 r_1, peak 3 within 2.5
// to 3.5 r_1; each is placed by a parabola through its bin and the two beside it. A peak must stand out on both sides:
// within r_1/2 of it g falls to the left and to the right by more than 4 errors of the difference (of counts, each pair
// seen from both its ends) and by more than .05; else it is missing, and with peak 1 all are. Source: S3 Table 2, whose
// peaks are read off curves; theory sec. 4.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "jamscape/base/random.hpp"
#include "jamscape/stats/resampling.hpp"

namespace jam {

/// Positions, NaN where a peak is missing. The bins are of equal width; all spans have the same length (else a data
/// error). Bins without `ideal` end the curve.
std::array<double, 3> shell_peaks(std::span<const double> distance, std::span<const double> pairs,
                                  std::span<const double> ideal);

/// Of the sums over parts (reference particles, or realisations), pairs[part][bin]; errors by bootstrap over the parts.
/// Resamples in which a peak is missing are left out; no error where they are the majority, or with fewer than 2 parts.
/// Estimate::n is the number of parts.
std::array<Estimate, 3> shell_peaks(std::span<const double> distance, std::span<const std::vector<double>> pairs,
                                    std::span<const std::vector<double>> ideal, std::size_t resamples, Random& random);

}  // namespace jam
