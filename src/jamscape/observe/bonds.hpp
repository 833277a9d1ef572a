// Which bodies touch: the contacts of a packing seen as pairs of bodies.
//
// A contact is there where its overlap is >= 0 (S1 App. B) or it carries a force: what a file lists with a force is
// believed where rounded positions show a gap. Every measure goes by this one rule. A pair of bodies with several
// contacts (clusters) is one bond. Wall contacts count for the degree of a grain, each bead and each end of an arm for
// one, but are no bonds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "jamscape/packing/cell.hpp"
#include "jamscape/packing/packing.hpp"

namespace jam {

struct Bonds {
  std::vector<std::uint32_t> contact;       ///< of each touching pair of grains: the index of its first contact
  std::vector<std::uint32_t> wall_contact;  ///< indices of the wall contacts that touch
  std::vector<std::uint32_t> grains;        ///< of each grain: the number of grains it touches
  std::vector<std::uint32_t> walls;         ///< of each grain: the number of its wall contacts

  std::size_t size() const { return contact.size(); }
  std::uint32_t degree(std::size_t grain) const { return grains[grain] + walls[grain]; }
  bool rattles(std::size_t grain) const { return degree(grain) < 2; }
};

/// Throws a data error where a contact names a body that is not there, or the contacts are not sorted.
Bonds find_bonds(const Packing& packing);

/// Whether a contact of the list is there.
inline bool touches(const Contacts& k, std::size_t c) {
  return k.overlap[c] >= 0 || k.normal_force[c] != 0 || norm(k.tangential_force[c]) != 0;
}

/// The next contact of the pair that contact c belongs to, or the number of contacts.
inline std::size_t next_of_pair(const Contacts& contacts, std::size_t c) {
  const std::size_t next = c + 1;  // its j differs nearly always, its i may or may not: j first
  return next < contacts.size() && contacts.j[next] == contacts.j[c] && contacts.i[next] == contacts.i[c]
             ? next
             : contacts.size();
}

/// From the centre of the first body of contact c to that of the second, the copy that touches; two grains only.
inline Vec3 branch(const Packing& packing, std::size_t c) {
  const Contacts& k = packing.contacts;
  const Vec3 l = packing.grains.position[static_cast<std::size_t>(k.j[c])] - packing.grains.position[k.i[c]];
  return l + image_shift(packing.domain, k.image[c]);
}

/// Force on the first body of a pair, summed over its contacts from contact c on: normal parts only, or all of it.
Vec3 normal_force_of_pair(const Contacts& contacts, std::size_t c);
Vec3 total_force_of_pair(const Contacts& contacts, std::size_t c);

}  // namespace jam
