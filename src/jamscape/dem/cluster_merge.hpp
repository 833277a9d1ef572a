// Contacts that count as one (theory sec. 3, DuplicateRule::merge).
#pragma once

#include "jamscape/dem/cluster_kernel.hpp"

namespace jam {

/// Of the contacts of each pair of bodies, deepest first, drops those whose point lies closer than the smaller arm
/// radius to the point of one that is kept; equal depths: the first in the list is kept. Returns, for every contact
/// dropped, its pair and the pair that is kept for it.
struct Merged {
  std::uint32_t dropped, kept;
};
std::vector<Merged> merge_duplicates(const ClusterState& bodies, const ArmPairs& pairs, const PressRule& rule,
                                     ArmContacts& contacts);

/// Hands the spring of a dropped contact to the one kept in its place where that has none.
void hand_over_springs(const std::vector<Merged>& merged, ArmPairs& pairs);

}  // namespace jam
