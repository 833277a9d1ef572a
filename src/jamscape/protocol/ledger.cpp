#include "jamscape/protocol/ledger.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "jamscape/base/flush_to_zero.hpp"
#include "jamscape/protocol/driver.hpp"

namespace jam {

LedgerStart ledger_start(const SystemOptions& system, double kinetic) {
  double fastest = 0;
  if (closes_from_all_sides(system.domain.walls))
    for (const StageOptions& stage : system.stages)
      if (stage.traits().moves) fastest = std::max(fastest, stage.speed);
  return {kinetic, std::max(kinetic, 0.5 * static_cast<double>(system.grains.count) * fastest * fastest)};
}

LedgerStart ledger_start(const SystemOptions& system, const TaskKey& key) {
  const FlushToZero guard;
  SystemOptions quick = system;  // velocities of clusters do not depend on where the bodies lie
  if (engine_of(system) == EngineKind::clusters) quick.start.layout = StartLayout::lattice;
  return ledger_start(system, make_driver(quick, key)->kinetic_energy());
}

double ledger_error(double ledger_sum, double turned_over, const LedgerStart& start) {
  const double off = std::abs(ledger_sum - start.energy);
  if (!std::isfinite(off) || !std::isfinite(turned_over)) return std::numeric_limits<double>::infinity();
  return off == 0 ? 0 : off / (start.scale + turned_over);
}

void check_ledger(const Packing& packing, const LedgerStart& start, double largest,
                  const IntegratorOptions& integrator) {
  const EnergyLedger& e = packing.energy;
  if (!(ledger_error(e.sum(), e.turned_over(), start) > largest)) return;
  throw Diverged(fmt::format(
      "step {}: the energy ledger is off by {:.3g} where {:.3g} was turned over, so the integrator makes or loses "
      "energy: integrator.step = {} is too long for the stiffness, the damping or the friction at this compression; "
      "half of it may do{}, and study.ledger = \"open\" goes on with every such frame marked",
      packing.step, std::abs(e.sum() - start.energy), start.scale + e.turned_over(), integrator.step,
      integrator.scheme == Scheme::verlet ? "" : ", or integrator.scheme = \"verlet\""));
}

}  // namespace jam
