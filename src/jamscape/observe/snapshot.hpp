// One packing with the things many measures share, each computed once and only when asked for. Not thread-safe: one
// snapshot belongs to one thread.
#pragma once

#include <optional>
#include <vector>

#include "jamscape/network/graph.hpp"
#include "jamscape/observe/options.hpp"
#include "jamscape/packing/packing.hpp"
#include "jamscape/topology/persistence.hpp"

namespace jam {

/// The force network of a packing: the bridge from grains to graphs.
struct ForceNetwork {
  WeightedGraph graph;                  ///< vertices = grains (index as in Packing::grains); weights in mean forces
  double mean_force = 0;                ///< mean over the edges kept, before normalisation and clamp
  std::vector<std::uint32_t> contact;   ///< of each edge: the index of its (first) contact in Packing::contacts
};

class Snapshot {
 public:
  Snapshot(const Packing& packing, const MeasureOptions& options) : packing_(packing), options_(options) {}

  const Packing& packing() const { return packing_; }
  const MeasureOptions& options() const { return options_; }
  const ForceNetwork& network() const;
  const Diagram& diagram() const;

 private:
  const Packing& packing_;
  const MeasureOptions& options_;
  mutable std::optional<ForceNetwork> network_;
  mutable std::optional<Diagram> diagram_;
};

}  // namespace jam
