// P(F): density of the contact forces in units of their mean, F/<F>, over the edges of the force network, unclamped.
//
//   integral of P over all F = 1: forces outside the bins count in the norm. Bins are logarithmic (S1) or linear (S2).
// Source: S1 Sec. III.B, Figs. 9 and 10, S2 Fig. 3 (bins unstated there); theory sec. 4.
#pragma once

#include "jamscape/observe/measure.hpp"
#include "jamscape/stats/histogram.hpp"

namespace jam {

/// Edges whose (first) contact lies within options.force_margin of a wall are left out, in the mean too.
Histogram force_distribution(const Packing& packing, const ForceNetwork& network, const MeasureOptions& options);

Measure force_distribution_measure();

}  // namespace jam
