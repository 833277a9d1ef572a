#include "jamscape/protocol/container_driver.hpp"

#include <algorithm>

namespace jam {

ContainerDriver::ContainerDriver(const SystemOptions& system, const TaskKey& key)
    : ContainerDriver(system, key, cluster_room(system, key)) {}

ContainerDriver::ContainerDriver(const SystemOptions& system, const TaskKey& key, const ClusterRoom& room)
    : EngineDriver(cluster_start(system, key, room), system), container_(room.container) {}

void ContainerDriver::begin(const Leg& leg) {
  const ClusterWall& wall = engine_.walls()[lid()];
  if (leg.kind == LegKind::press) engine_.place_wall(lid(), std::min(wall.position, engine_.highest(1)));
  engine_.set_wall_velocity(lid(), -leg.speed);
}

double ContainerDriver::packing_fraction() const {
  return container_.packing_fraction(std::min(engine_.walls()[lid()].position, engine_.highest(1)));
}

}  // namespace jam
