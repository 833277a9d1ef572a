// Networks of real packings: a CSV (or .csv.gz) with the comment `# vertices: N`, the header `i,j,force` and an edge a
// row.
#pragma once

#include <filesystem>

#include "jamscape/network/graph.hpp"

namespace jam::examples {

/// Throws std::runtime_error with file and line for anything else.
WeightedGraph read_network(const std::filesystem::path& file);

}  // namespace jam::examples
