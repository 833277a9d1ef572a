#include "jamscape/observe/contacts.hpp"

#include "jamscape/base/mean.hpp"
#include "jamscape/observe/entry.hpp"

namespace jam {

double mean_normal_force(const Snapshot& snapshot) {
  const ForceNetwork& net = snapshot.network();
  if (snapshot.options().force == EdgeForce::normal || net.contact.empty()) return net.mean_force;
  std::vector<double> forces;
  for (const std::uint32_t c : net.contact)
    forces.push_back(norm(normal_force_of_pair(snapshot.packing().contacts, c)));
  return mean_of(forces);
}

Measure contacts_measure() {
  return frame_measure(
      {"contacts", "contacts and their mean force",
       "edges of the force network: pairs of grains with a contact whose overlap is >= 0 or that carries a force (the "
       "rule "
       "of every measure for which contacts there are); wall contacts are no edges; with remove_rattlers without the "
       "edges of grains with fewer than two contacts (walls counted). mean_normal_force = "
       "(1/edges) sum |F_n|, the force that weights are measured in; of clusters that touch with several arms |sum F_n "
       "n| "
       "of the pair.",
       "S1 Sec. II.C, App. B"},
      {{"contacts", "", "edges of the force network"},
       {"wall_contacts", "", "contacts of grains with walls (each bead of a wall, each end of an arm is one)"},
       {"mean_normal_force", "m d/tau_c^2", "mean normal force of the edges; 0 without edges"}},
      [](const Snapshot& s) {
        return std::vector<double>{static_cast<double>(s.network().graph.edges()),
                                   static_cast<double>(s.bonds().wall_contact.size()), mean_normal_force(s)};
      });
}

}  // namespace jam
