#include "jamscape/protocol/driver.hpp"

#include "jamscape/dem/parts.hpp"
#include "jamscape/protocol/box_driver.hpp"
#include "jamscape/protocol/container_driver.hpp"
#include "jamscape/protocol/start.hpp"

namespace jam {

int axis_of_height(const SystemOptions& system) {
  const bool falls =
      has_lid(system.domain.walls) || (system.domain.walls == WallModel::flat && system.domain.gravity != 0);
  return falls ? 1 : static_cast<int>(system.domain.dimension) - 1;
}

std::unique_ptr<Driver> make_driver(const SystemOptions& system, const TaskKey& key) {
  check_start(system);
  switch (engine_of(system)) {
    case EngineKind::clusters:
      return std::make_unique<ContainerDriver>(system, key);
    case EngineKind::discs:
      return std::make_unique<BoxDriver<2>>(system, key);
    case EngineKind::spheres:
      break;
  }
  return std::make_unique<BoxDriver<3>>(system, key);
}

int threads_of_use(const SystemOptions& system, int wanted) {
  if (engine_of(system) == EngineKind::clusters) return 1;
  return Parts(static_cast<int>(system.domain.dimension), static_cast<std::size_t>(system.grains.count), 0)
      .threads_of_use(wanted);
}

}  // namespace jam
