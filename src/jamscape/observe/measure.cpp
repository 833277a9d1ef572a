#include "jamscape/observe/measure.hpp"

#include "jamscape/base/error.hpp"
#include "jamscape/base/nearest.hpp"
#include "jamscape/observe/backbone.hpp"
#include "jamscape/observe/balance.hpp"
#include "jamscape/observe/bond_order.hpp"
#include "jamscape/observe/box.hpp"
#include "jamscape/observe/contact_forces.hpp"
#include "jamscape/observe/contacts.hpp"
#include "jamscape/observe/coordination.hpp"
#include "jamscape/observe/energy.hpp"
#include "jamscape/observe/force_distribution.hpp"
#include "jamscape/observe/force_tail.hpp"
#include "jamscape/observe/kinetic_stress.hpp"
#include "jamscape/observe/level_sets.hpp"
#include "jamscape/observe/pair_correlation.hpp"
#include "jamscape/observe/particle_stress.hpp"
#include "jamscape/observe/percolation.hpp"
#include "jamscape/observe/persistence_measures.hpp"
#include "jamscape/observe/radial_distribution.hpp"
#include "jamscape/observe/solid_fraction.hpp"
#include "jamscape/observe/stress.hpp"
#include "jamscape/observe/walls.hpp"

namespace jam {

const std::vector<Measure>& measures() {
  static const std::vector<Measure> all = {
      contacts_measure(),
      coordination_measure(),
      backbone_measure(),
      bond_order_measure(),
      persistence_bins_measure(),
      total_persistence_measure(),
      percolation_measure(),
      stress_measure(),
      kinetic_stress_measure(),
      walls_measure(),
      balance_measure(),
      energy_measure(),
      box_measure(),
      solid_fraction_measure(),
      contact_forces_measure(),
      force_tail_measure(),
      rdf_peaks_measure(),
      betti_measure(),
      level_sets_measure(),
      pair_correlation_measure(),
      force_distribution_measure(),
      contact_force_distribution_measure(),
      stress_distribution_measure(),
      radial_distribution_measure(),
      diagram_measure(),
      particle_stress_measure(),
  };
  return all;
}

const Measure& find_measure(std::string_view name) {
  std::vector<std::string> known;
  for (const Measure& m : measures()) {
    if (m.name == name) return m;
    known.push_back(m.name);
  }
  const std::string close = nearest(name, known);
  std::string list;
  for (const std::string& k : known) list += (list.empty() ? "" : ", ") + k;
  throw usage_error("there is no measure '" + std::string(name) + "'", {},
                    (close.empty() ? "" : "did you mean '" + close + "'? ") + ("the measures are " + list));
}

}  // namespace jam
