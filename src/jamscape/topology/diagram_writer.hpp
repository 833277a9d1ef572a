// Turns the partners of a filtration into the pairs of a diagram, in its order, and names the cliques among them.
#pragma once

#include <cstdint>
#include <vector>

#include "jamscape/topology/filtration.hpp"
#include "jamscape/topology/persistence.hpp"

namespace jam {

/// Every cell must have its partner. `memory` may be shared by calls; its contents do not matter.
Diagram write_diagram(const Filtration& cells, const PersistenceOptions& options, std::vector<std::uint32_t>& memory);

}  // namespace jam
