#include "jamscape/observe/snapshot.hpp"

#include "jamscape/observe/box_sides.hpp"
#include "jamscape/observe/threshold_grid.hpp"

namespace jam {

const Bonds& Snapshot::bonds() const {
  if (!bonds_) bonds_ = find_bonds(packing_);
  return *bonds_;
}

const ForceNetwork& Snapshot::network() const {
  if (!network_) network_ = force_network(packing_, bonds(), options_);
  return *network_;
}

const Diagram& Snapshot::diagram() const {
  if (diagram_) return *diagram_;
  const PersistenceOptions wanted{.max_dimension = packing_.dimension - 1};
  const WeightedGraph& graph = network().graph;
  diagram_ = memory_ != nullptr ? persistence(graph, wanted, *memory_) : persistence(graph, wanted);
  return *diagram_;
}

const std::vector<ClusterLevel>& Snapshot::levels() const {
  if (!levels_) levels_ = cluster_levels(packing_, network(), threshold_grid(options_.level_max, options_.level_step));
  return *levels_;
}

}  // namespace jam
