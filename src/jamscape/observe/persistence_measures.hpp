// What is read from the persistence diagram of the force network; forces in units of the mean force.
// Definitions: topology/bins.hpp, topology/total.hpp, topology/betti.hpp, topology/persistence.hpp.
#pragma once

#include "jamscape/observe/measure.hpp"
#include "jamscape/topology/bins.hpp"

namespace jam {

/// The bins of the options: whether a lifetime on the border is rough.
BinOptions bin_options(const MeasureOptions& options);

Measure persistence_bins_measure();
Measure total_persistence_measure();
Measure betti_measure();
Measure diagram_measure();

}  // namespace jam
