#include "jamscape/observe/bond_order.hpp"

#include <cmath>

#include "jamscape/observe/bond_blocks.hpp"
#include "jamscape/observe/entry.hpp"

namespace jam {
namespace {

/// From centre to centre of two clusters.
Vec3 direction(const Packing& packing, std::size_t c) {
  const Vec3 l = branch(packing, c);
  const double length = norm(l);
  return length > 0 ? (1 / length) * l : packing.contacts.normal[c];
}

BondBlocks list_bonds(const Packing& packing, const Bonds& pairs) {
  const Contacts& k = packing.contacts;
  BondBlocks list(pairs.grains);
  const auto add = [&](std::uint32_t c, const Vec3& n) {
    list.add(k.i[c], n[0], n[1]);
    list.add(static_cast<std::size_t>(k.j[c]), -n[0], -n[1]);
  };
  if (packing.shapes.empty())
    for (const std::uint32_t c : pairs.contact) add(c, k.normal[c]);
  else
    for (const std::uint32_t c : pairs.contact) add(c, direction(packing, c));
  return list;
}

}  // namespace

BondOrder bond_order(const Packing& packing, const Bonds& pairs) {
  const std::size_t grains = pairs.grains.size();
  if (grains == 0 || packing.dimension != 2) return {};
  const BondBlocks list = list_bonds(packing, pairs);
  const auto orders = list.orders();
  double printed = 0, closed = 0, local = 0, re = 0, im = 0;
  for (std::size_t i = 0; i < grains; ++i) {
    const LaneOrders& of = orders[list.block(i)];
    const std::size_t lane = list.lane(i);
    printed += of.printed[lane];
    closed += of.closed[lane];
    local += of.local[lane];
    re += of.re[lane];
    im += of.im[lane];
  }
  const auto n = static_cast<double>(grains);
  return {printed / n, closed / n, local / n, std::sqrt(re * re + im * im) / n};
}

Measure bond_order_measure() {
  return frame_measure(
      {"bond_order", "six-fold bond orientation",
       "psi6 = <(1/N) sum_j (N_b - 1)^-1 sum_k cos 6 theta_k>, theta_k the gaps between consecutive "
       "contacts of a grain "
       "sorted by their angle in [-pi, pi), the gap from the last to the first left out. As printed it has no phases "
       "that cancel: 1 for a hexagonal lattice, but "
       "-1 for a square one "
       "and +1 for a straight chain. psi6_closed has cos 6 theta of all N_b gaps, divided by N_b. A grain "
       "with one bond or none contributes 0 to both. psi6_local = (1/N) sum_j |q_j| and psi6_global "
       "= |(1/N) sum_j q_j|, q_j = (1/N_b) sum over bonds of exp(6 i theta), theta the angle of the "
       "bond itself, are the usual order parameters: one bond gives |q_j| = 1, none q_j = 0. Bonds "
       "are the touching pairs of the measure contacts, along the contact's normal (of clusters from "
       "centre to centre); N all grains. All are 0 in three dimensions.",
       "S1 Sec. III.B, Fig. 8; theory sec. 4"},
      {{"psi6", "", "formula of S1: N_b - 1 gaps, the one across the negative x axis left out"},
       {"psi6_closed", "", "the same with all N_b gaps"},
       {"psi6_local", "", "mean over grains of |<exp(6 i theta)> over its bonds|"},
       {"psi6_global", "", "|mean over grains of <exp(6 i theta)> over its bonds|"}},
      [](const Snapshot& s) {
        const BondOrder b = bond_order(s.packing(), s.bonds());
        return std::vector<double>{b.printed, b.closed, b.local, b.global};
      });
}

}  // namespace jam
