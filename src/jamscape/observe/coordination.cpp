#include "jamscape/observe/coordination.hpp"

#include "jamscape/observe/entry.hpp"

namespace jam {

Coordination coordination(const Bonds& bonds) {
  Coordination c;
  const std::size_t n = bonds.grains.size();
  if (n == 0) return c;
  std::size_t multi = 0, contacts_of_multi = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (bonds.rattles(i)) continue;
    ++multi;
    contacts_of_multi += bonds.degree(i);
  }
  const auto grains = static_cast<double>(n), both_ends = 2 * static_cast<double>(bonds.size());
  c.z = both_ends / grains;
  c.z_walls = (both_ends + static_cast<double>(bonds.wall_contact.size())) / grains;
  if (multi > 0) c.z_multi = static_cast<double>(contacts_of_multi) / static_cast<double>(multi);
  c.rattlers = static_cast<double>(n - multi) / grains;
  return c;
}

Measure coordination_measure() {
  return frame_measure(
      {"coordination", "mean contact number",
       "z = 2 N_pp/N over all N grains, N_pp the touching pairs of grains (a contact with overlap >= 0 or a force; "
       "clusters that touch with several arms are one pair), rattlers among them. z_walls = (2 N_pp + N_pw)/N, N_pw "
       "wall contacts. z_multi = (sum over grains with two or more contacts, walls counted, of their contacts)/(their "
       "number). Rattlers are among the N: z at jamming is lower than the isostatic number of the rigid "
       "part.",
       "S1 Table I; theory sec. 4, 6a"},
      {{"z", "", "touching grains per grain, all grains, walls excluded"},
       {"z_walls", "", "contacts per grain, wall contacts (each bead of a wall, each end of an arm) counted"},
       {"z_multi", "",
        "contacts per grain over the grains with two or more, wall contacts counted; 0 if there are none"},
       {"rattlers", "", "fraction of grains with fewer than two contacts, wall contacts counted"}},
      [](const Snapshot& s) {
        const Coordination c = coordination(s.bonds());
        return std::vector<double>{c.z, c.z_walls, c.z_multi, c.rattlers};
      });
}

}  // namespace jam
