#include "jamscape/observe/snapshot.hpp"

#include <utility>

#include "jamscape/observe/box_sides.hpp"
#include "jamscape/observe/threshold_grid.hpp"

namespace jam {

Snapshot::~Snapshot() {
  if (memory_ != nullptr && history_) memory_->history = std::move(*history_);
}

const Bonds& Snapshot::bonds() const {
  if (!bonds_) bonds_ = find_bonds(packing_);
  return *bonds_;
}

const ForceNetwork& Snapshot::network() const {
  if (!network_) network_ = force_network(packing_, bonds(), options_);
  return *network_;
}

const ComponentHistory& Snapshot::history() const {
  if (history_) return *history_;
  ComponentHistory history;
  if (memory_ != nullptr) std::swap(history, memory_->history);
  history.build(network().graph);
  history_ = std::move(history);
  return *history_;
}

const Diagram& Snapshot::diagram() const {
  if (diagram_) return *diagram_;
  const PersistenceOptions wanted{.max_dimension = packing_.dimension - 1};
  if (memory_ != nullptr) {
    diagram_ = persistence(history(), wanted, memory_->persistence);
  } else {
    PersistenceWorkspace once;
    diagram_ = persistence(history(), wanted, once);
  }
  return *diagram_;
}

const std::vector<ClusterLevel>& Snapshot::levels() const {
  if (levels_) return *levels_;
  const std::vector<double> thresholds = threshold_grid(options_.level_max, options_.level_step);
  const std::vector<Sides> sides = sides_of_vertices(network(), touched_sides(packing_, bonds()));
  const std::vector<BoxCopy> images = edge_images(packing_, network());
  levels_ = images.empty() ? level_sweep(history(), thresholds, sides)
                           : level_sweep(network().graph, thresholds, {sides, images, cell_edges(packing_.domain)});
  return *levels_;
}

}  // namespace jam
