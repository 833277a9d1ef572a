#include "jamscape/observe/energy.hpp"

#include "jamscape/observe/entry.hpp"

namespace jam {

Measure energy_measure() {
  const char* unit = "m d^2/tau_c^2";
  return frame_measure(
      {"energy", "energy ledger",
       "ledger_sum = kinetic + elastic + damped + rubbed - wall_work - gravity_work stays at its first value to the "
       "integrator's order. Missing where the ledger is not given.",
       "theory sec. 6b"},
      {{"kinetic", unit, "energy of translation and rotation, now"},
       {"elastic", unit, "energy of the normal and tangential springs, now"},
       {"damped", unit, "taken by the dashpots since the start"},
       {"rubbed", unit, "taken by friction since the start"},
       {"wall_work", unit, "done on the grains by the walls since the start"},
       {"gravity_work", unit, "done on the grains by gravity since the start"},
       {"ledger_sum", unit, "energy that should not change along a run"}},
      [](const Snapshot& s) {
        const EnergyLedger& e = s.packing().energy;
        return std::vector<double>{e.kinetic, e.elastic, e.damped, e.rubbed, e.wall_work, e.gravity_work, e.sum()};
      },
      {.known = {&Knowledge::energies}});
}

}  // namespace jam
