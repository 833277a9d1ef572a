// The weights of a network made comparable.
#pragma once

#include <algorithm>

#include "jamscape/base/mean.hpp"
#include "jamscape/network/graph.hpp"

namespace jam::app {

/// Divides by the mean weight and returns it; a network without weight stays as it is.
inline double normalise(WeightedGraph& graph) {
  const double mean = mean_of(graph.weight);
  divide_by_mean(graph.weight, mean);
  return mean;
}

inline void clamp(WeightedGraph& graph, double largest) {
  for (double& w : graph.weight) w = std::min(w, largest);
}

}  // namespace jam::app
