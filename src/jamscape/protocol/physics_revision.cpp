// Which revision of the physics a simulation is of; what each number means stands in simulate.hpp.
#include <algorithm>

#include "jamscape/dem/parts.hpp"
#include "jamscape/protocol/simulate.hpp"

namespace jam {
namespace {

/// Walls that are faster than the grains at their start.
bool outrun_grains(const SystemOptions& system) {
  return std::any_of(system.stages.begin(), system.stages.end(), [&](const StageOptions& stage) {
    return stage.traits().moves && stage.speed > system.start.speed;
  });
}

}  // namespace

int physics_revision(const SystemOptions& system) {
  const ContactOptions& contact = system.contact;
  if (contact.tangential_stiffness == 0 && !hertzian(contact.law) &&
      (contact.friction > 0 || contact.wall_friction > 0))
    return 9;
  if (engine_of(system) == EngineKind::clusters) return 3;
  if (system.domain.walls == WallModel::periodic) return 8;
  if (system.domain.walls == WallModel::flat && outrun_grains(system)) return 10;
  if (!system.stages.empty() && system.stages.front().kind != StageKind::compress) return 7;
  if (system.domain.dimension == 3) return 5;
  if (system.grains.count >= static_cast<std::int64_t>(Parts::least_grains)) return 4;
  return hertzian(system.contact.law) ? 2 : 1;
}

}  // namespace jam
