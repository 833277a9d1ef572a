// What is read from the persistence diagram of the force network; forces in units of the mean force.
// Definitions: topology/bins.hpp, topology/total.hpp, topology/betti.hpp, topology/persistence.hpp.
#pragma once

#include "jamscape/observe/measure.hpp"

namespace jam {

Measure persistence_bins_measure();
Measure total_persistence_measure();
Measure betti_measure();
Measure diagram_measure();

}  // namespace jam
