// One packing with the things many measures share, each computed once and only when asked for. Not thread-safe: one
// snapshot belongs to one thread.
#pragma once

#include <optional>

#include "jamscape/network/level_sweep.hpp"
#include "jamscape/observe/bonds.hpp"
#include "jamscape/observe/force_network.hpp"
#include "jamscape/observe/options.hpp"
#include "jamscape/packing/packing.hpp"
#include "jamscape/topology/persistence.hpp"

namespace jam {

class Snapshot {
 public:
  /// Packing and memory must outlive the snapshot; the options are copied. Snapshots taken one after the other are
  /// faster with memory that they share; it never influences a result.
  Snapshot(const Packing& packing, const MeasureOptions& options, PersistenceWorkspace* memory = nullptr)
      : packing_(packing), options_(options), memory_(memory) {}
  Snapshot(Packing&&, const MeasureOptions&, PersistenceWorkspace* memory = nullptr) = delete;

  const Packing& packing() const { return packing_; }
  const MeasureOptions& options() const { return options_; }
  const Bonds& bonds() const;
  const ForceNetwork& network() const;
  /// Of the network's clique complex, in the homology dimensions 0 to D - 1.
  const Diagram& diagram() const;
  /// Clusters of the network at the thresholds of the level sets, the first of which is 0.
  const std::vector<ClusterLevel>& levels() const;

 private:
  const Packing& packing_;
  MeasureOptions options_;
  PersistenceWorkspace* memory_;
  mutable std::optional<Bonds> bonds_;
  mutable std::optional<ForceNetwork> network_;
  mutable std::optional<Diagram> diagram_;
  mutable std::optional<std::vector<ClusterLevel>> levels_;
};

}  // namespace jam
