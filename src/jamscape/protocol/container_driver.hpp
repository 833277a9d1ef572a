// Rigid clusters in a container with a lid.
#pragma once

#include "jamscape/dem/cluster_engine.hpp"
#include "jamscape/protocol/cluster_start.hpp"
#include "jamscape/protocol/engine_driver.hpp"

namespace jam {

class ContainerDriver : public EngineDriver<ClusterEngine> {
 public:
  ContainerDriver(const SystemOptions& system, const TaskKey& key);

  void begin(const Leg& leg) override;
  bool reached(const Leg& leg) override { return engine_.wall_force(lid())[1] >= leg.force; }
  /// Up to the lid, or to the highest body while the lid is not there yet.
  double packing_fraction() const override;
  /// Its steps are not shared.
  int set_threads(int) override { return 1; }
  double work_per_glance() const override { return 2500; }

 private:
  ContainerDriver(const SystemOptions& system, const TaskKey& key, const ClusterRoom& room);
  double plain_packing_fraction() const override { return packing_fraction(); }
  std::size_t lid() const { return engine_.walls().size() - 1; }

  Container container_;
};

}  // namespace jam
