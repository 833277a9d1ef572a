// Persistence of a graph that is nearly complete takes more memory and time than anyone meant.
#pragma once

#include <fmt/format.h>

#include "jamscape/base/error.hpp"
#include "jamscape/topology/clique_estimate.hpp"

namespace jam::app {

inline void refuse_large(const WeightedGraph& graph, const PersistenceOptions& options, const std::string& file) {
  const CliqueEstimate estimate = estimate_cliques(graph, options);
  if (!estimate.large) return;
  throw data_error(
      fmt::format(
          "the diagrams up to dimension {} need about {:.2g} cliques and {:.2g} GB of memory, and their time: {} "
          "edges among {} vertices leave hardly a pair unlinked",
          options.max_dimension, estimate.cliques, estimate.bytes / 1e9, graph.edges(), graph.vertices),
      file, "ask for a lower dimension, leave out weak edges, or say --anyway");
}

}  // namespace jam::app
