#include "jamscape/observe/snapshot.hpp"

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
  if (!diagram_) diagram_ = persistence(network().graph, {.max_dimension = packing_.dimension - 1});
  return *diagram_;
}

}  // namespace jam
