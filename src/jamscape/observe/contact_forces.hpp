// Normal forces of single contacts, P(f) as S3 has it: every contact between bodies with F_n > 0 by itself (clusters
// have several a pair), in units of their mean; wall contacts left out, rattlers not removed. force_distribution.hpp
// has the forces of the network's edges, which are pairs. What lies beyond the last bin counts in the norm. Source: S3
// Data analysis, Figs. 5, 6; theory sec. 4.
#pragma once

#include <vector>

#include "jamscape/observe/measure.hpp"
#include "jamscape/stats/histogram.hpp"

namespace jam {

/// F_n of each contact between bodies with F_n > 0, in the order of the contacts; those whose point is within
/// options.force_margin of a wall left out.
std::vector<double> contact_forces(const Packing& packing, const MeasureOptions& options = {});

/// A histogram from 0 on in the bins of the options, as columns: centre, density, count, norm (values times width).
std::vector<std::vector<double>> distribution_columns(const std::vector<double>& values, const MeasureOptions& options);

Measure contact_forces_measure();
Measure contact_force_distribution_measure();

}  // namespace jam
