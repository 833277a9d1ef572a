#include "jamscape/observe/bonds.hpp"

#include <fmt/format.h>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

void check(const Packing& packing, std::size_t c) {
  const Contacts& k = packing.contacts;
  const auto grains = static_cast<std::int64_t>(packing.grains.size());
  const auto walls = static_cast<std::int64_t>(packing.walls.size());
  const std::int64_t i = k.i[c], j = k.j[c];
  if (i >= grains || j >= grains || j < -walls)
    throw data_error(
        fmt::format("contact {} joins bodies {} and {}, but there are {} grains and {} walls", c, i, j, grains, walls));
  if (j >= 0 && j <= i) throw data_error(fmt::format("contact {} joins grains {} and {}; it must have i < j", c, i, j));
  if (c > 0 && (k.i[c] < k.i[c - 1] || (k.i[c] == k.i[c - 1] && k.j[c] < k.j[c - 1])))
    throw data_error(fmt::format("contact {} is out of order", c), {}, "sort the contacts by (i, j, part_i, part_j)");
}

}  // namespace

Bonds find_bonds(const Packing& packing) {
  const Contacts& k = packing.contacts;
  Bonds bonds;
  bonds.grains.assign(packing.grains.size(), 0);
  bonds.walls.assign(packing.grains.size(), 0);
  bonds.contact.reserve(k.size());
  for (std::size_t c = 0; c < k.size(); ++c) {
    check(packing, c);
    if (!(k.overlap[c] >= 0)) continue;
    const std::uint32_t i = k.i[c];
    if (k.j[c] < 0) {
      ++bonds.walls[i];
      ++bonds.wall_contacts;
      continue;
    }
    const auto j = static_cast<std::uint32_t>(k.j[c]);
    if (!bonds.contact.empty() && k.i[bonds.contact.back()] == i && k.j[bonds.contact.back()] == k.j[c]) continue;
    bonds.contact.push_back(static_cast<std::uint32_t>(c));
    ++bonds.grains[i];
    ++bonds.grains[j];
  }
  return bonds;
}

Vec3 branch(const Packing& packing, std::size_t c) {
  const Contacts& k = packing.contacts;
  Vec3 l = packing.grains.position[static_cast<std::size_t>(k.j[c])] - packing.grains.position[k.i[c]];
  for (int a = 0; a < 3; ++a)
    l[a] += k.image[c][static_cast<std::size_t>(a)] * (packing.domain.hi[a] - packing.domain.lo[a]);
  return l;
}

Vec3 normal_force_of_pair(const Contacts& contacts, std::size_t c) {
  Vec3 sum{};
  for (; c < contacts.size(); c = next_of_pair(contacts, c))
    if (contacts.overlap[c] >= 0) sum -= contacts.normal_force[c] * contacts.normal[c];
  return sum;
}

Vec3 total_force_of_pair(const Contacts& contacts, std::size_t c) {
  Vec3 sum{};
  for (; c < contacts.size(); c = next_of_pair(contacts, c))
    if (contacts.overlap[c] >= 0) sum += contacts.tangential_force[c] - contacts.normal_force[c] * contacts.normal[c];
  return sum;
}

}  // namespace jam
