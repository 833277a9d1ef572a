// One packing with the things many measures share, each computed once and only when asked for. Not thread-safe: one
// snapshot belongs to one thread.
#pragma once

#include <optional>

#include "jamscape/network/component_history.hpp"
#include "jamscape/network/level_sweep.hpp"
#include "jamscape/observe/bonds.hpp"
#include "jamscape/observe/force_network.hpp"
#include "jamscape/observe/options.hpp"
#include "jamscape/packing/packing.hpp"
#include "jamscape/topology/persistence.hpp"

namespace jam {

/// Memory of snapshots taken one after the other: they are faster with it. It never influences a result.
struct SnapshotMemory {
  ComponentHistory history;  ///< lent to one snapshot at a time
  PersistenceWorkspace persistence;
};

class Snapshot {
 public:
  /// Packing and memory must outlive the snapshot; the options are copied.
  Snapshot(const Packing& packing, const MeasureOptions& options, SnapshotMemory* memory = nullptr)
      : packing_(packing), options_(options), memory_(memory) {}
  Snapshot(Packing&&, const MeasureOptions&, SnapshotMemory* memory = nullptr) = delete;
  Snapshot(const Snapshot&) = delete;
  Snapshot& operator=(const Snapshot&) = delete;
  ~Snapshot();

  const Packing& packing() const { return packing_; }
  const MeasureOptions& options() const { return options_; }
  const Bonds& bonds() const;
  const ForceNetwork& network() const;
  /// The network's components as its edges come from strong to weak.
  const ComponentHistory& history() const;
  /// Of the network's clique complex, in the homology dimensions 0 to D - 1.
  const Diagram& diagram() const;
  /// Clusters of the network at the thresholds of the level sets, the first of which is 0. Percolation along an axis:
  /// from wall to wall, or around the box where it is periodic there.
  const std::vector<ClusterLevel>& levels() const;

 private:
  const Packing& packing_;
  MeasureOptions options_;
  SnapshotMemory* memory_;
  mutable std::optional<Bonds> bonds_;
  mutable std::optional<ForceNetwork> network_;
  mutable std::optional<ComponentHistory> history_;
  mutable std::optional<Diagram> diagram_;
  mutable std::optional<std::vector<ClusterLevel>> levels_;
};

}  // namespace jam
