#include "jamscape/protocol/ledger.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "jamscape/base/flush_to_zero.hpp"
#include "jamscape/protocol/scene.hpp"

namespace jam {

LedgerStart ledger_start(const SystemOptions& system, double kinetic) {
  double fastest = 0;
  if (!is_container(system.domain.walls))
    for (const StageOptions& stage : system.stages)
      if (stage.kind != StageKind::relax) fastest = std::max(fastest, stage.speed);
  return {kinetic, std::max(kinetic, 0.5 * static_cast<double>(system.grains.count) * fastest * fastest)};
}

LedgerStart ledger_start(const SystemOptions& system, const TaskKey& key) {
  const FlushToZero guard;
  if (is_container(system.domain.walls)) {
    SystemOptions quick = system;  // velocities do not depend on where the bodies lie
    quick.start.layout = StartLayout::lattice;
    return ledger_start(system, ContainerScene(quick, key).engine().kinetic_energy());
  }
  return ledger_start(system, system.domain.dimension == 2 ? BoxScene<2>(system, key).engine().kinetic_energy()
                                                           : BoxScene<3>(system, key).engine().kinetic_energy());
}

double ledger_error(double ledger_sum, double turned_over, const LedgerStart& start) {
  const double off = std::abs(ledger_sum - start.energy);
  if (!std::isfinite(off) || !std::isfinite(turned_over)) return std::numeric_limits<double>::infinity();
  return off == 0 ? 0 : off / (start.scale + turned_over);
}

}  // namespace jam
