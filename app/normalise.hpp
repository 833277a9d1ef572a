// The weights of a network made comparable.
#pragma once

#include <algorithm>

#include "jamscape/network/graph.hpp"

namespace jam::app {

/// Divides by the mean weight and returns it; a network without weight stays as it is.
inline double normalise(WeightedGraph& graph) {
  double sum = 0;
  for (const double w : graph.weight) sum += w;
  if (!(sum > 0)) return 0;
  const double mean = sum / static_cast<double>(graph.edges());
  for (double& w : graph.weight) w /= mean;
  return mean;
}

inline void clamp(WeightedGraph& graph, double largest) {
  for (double& w : graph.weight) w = std::min(w, largest);
}

}  // namespace jam::app
