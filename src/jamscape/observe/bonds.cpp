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

/// check() of all contacts at once: whether any is wrong. Words of one size and no branch, so that it fills vector
/// registers.
bool any_wrong(const Packing& packing) {
  const Contacts& k = packing.contacts;
  const auto grains = static_cast<std::int32_t>(packing.grains.size()),
             walls = static_cast<std::int32_t>(packing.walls.size());
  const auto word = [](bool b) { return static_cast<std::int32_t>(b); };
  std::int32_t wrong = 0;
  for (std::size_t c = 0; c < k.size(); ++c) {
    const auto i = static_cast<std::int32_t>(k.i[c]);
    const std::int32_t j = k.j[c];
    wrong |= word(i < 0) | word(i >= grains) | word(j >= grains) | word(j < -walls) | (word(j >= 0) & word(j <= i));
  }
  for (std::size_t c = 1; c < k.size(); ++c)
    wrong |= word(k.i[c] < k.i[c - 1]) | (word(k.i[c] == k.i[c - 1]) & word(k.j[c] < k.j[c - 1]));
  return wrong != 0;
}

}  // namespace

Bonds find_bonds(const Packing& packing) {
  const Contacts& k = packing.contacts;
  if (any_wrong(packing))
    for (std::size_t c = 0; c < k.size(); ++c) check(packing, c);
  Bonds bonds;
  bonds.grains.assign(packing.grains.size(), 0);
  bonds.walls.assign(packing.grains.size(), 0);
  bonds.contact.resize(k.size() + 1);
  std::size_t count = 0;
  std::int64_t last_i = -1, last_j = 0;
  bool found = false;  // whether the pair of the last contact touches; grains are counted without a branch
  for (std::size_t c = 0; c < k.size(); ++c) {
    const std::uint32_t i = k.i[c];
    const std::int32_t j = k.j[c];
    const bool there = touches(k, c);
    if (j < 0) {
      bonds.walls[i] += there;
      if (there) bonds.wall_contact.push_back(static_cast<std::uint32_t>(c));
      continue;
    }
    found &= (i == last_i) & (j == last_j);
    const bool bond = there & !found;
    bonds.contact[count] = static_cast<std::uint32_t>(c);
    count += bond;
    bonds.grains[i] += bond;
    bonds.grains[static_cast<std::size_t>(j)] += bond;
    found |= there;
    last_i = i;
    last_j = j;
  }
  bonds.contact.resize(count);
  return bonds;
}

Vec3 normal_force_of_pair(const Contacts& contacts, std::size_t c) {
  Vec3 sum{};
  for (; c < contacts.size(); c = next_of_pair(contacts, c))
    if (touches(contacts, c)) sum -= contacts.normal_force[c] * contacts.normal[c];
  return sum;
}

Vec3 total_force_of_pair(const Contacts& contacts, std::size_t c) {
  Vec3 sum{};
  for (; c < contacts.size(); c = next_of_pair(contacts, c))
    if (touches(contacts, c)) sum += contacts.tangential_force[c] - contacts.normal_force[c] * contacts.normal[c];
  return sum;
}

}  // namespace jam
