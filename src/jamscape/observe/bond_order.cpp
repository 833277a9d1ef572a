#include "jamscape/observe/bond_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "jamscape/observe/entry.hpp"

namespace jam {
namespace {

// exp(6 i theta); plain arithmetic, as std::complex looks for infinities in every product.
struct Phase {
  double re = 0, im = 0;
};

struct Bond {
  double order;  // increases with the angle in [-pi, pi)
  Phase six;
};

/// The same phase for both ends of a bond, whose directions are opposite.
Phase six_fold(double x, double y) {
  const double re2 = x * x - y * y, im2 = 2 * x * y;
  const double re3 = re2 * x - im2 * y, im3 = re2 * y + im2 * x;
  return {re3 * re3 - im3 * im3, 2 * re3 * im3};
}

double order(double x, double y) {
  const bool lower = (y < 0) | ((y == 0) & (x < 0));
  return (1 - 2 * static_cast<double>(lower)) * (1 - x);
}

double cos_of_gap(const Phase& a, const Phase& b) { return a.re * b.re + a.im * b.im; }

// The bonds of all grains, one grain after another.
struct BondList {
  std::vector<std::uint32_t> begin;
  std::vector<Bond> bonds;
};

// From centre to centre; of discs and spheres that is the normal.
Vec3 direction(const Packing& packing, std::size_t c) {
  if (packing.shapes.empty()) return packing.contacts.normal[c];
  const Vec3 l = branch(packing, c);
  const double length = norm(l);
  return length > 0 ? (1 / length) * l : packing.contacts.normal[c];
}

BondList list_bonds(const Packing& packing, const Bonds& pairs) {
  BondList list;
  list.begin.assign(pairs.grains.size() + 1, 0);
  for (std::size_t i = 0; i < pairs.grains.size(); ++i) list.begin[i + 1] = list.begin[i] + pairs.grains[i];
  list.bonds.resize(list.begin.back());
  std::vector<std::uint32_t> next(list.begin.begin(), list.begin.end() - 1);
  for (const std::uint32_t c : pairs.contact) {
    const Vec3 n = direction(packing, c);
    const Phase six = six_fold(n[0], n[1]);
    list.bonds[next[packing.contacts.i[c]]++] = {order(n[0], n[1]), six};
    list.bonds[next[static_cast<std::size_t>(packing.contacts.j[c])]++] = {order(-n[0], -n[1]), six};
  }
  return list;
}

/// What one grain adds to the sums.
struct GrainOrder {
  double printed = 0, closed = 0, local = 0;
  Phase mean;
};

GrainOrder order_of(std::span<const Phase> b) {  // by angle
  const auto n = static_cast<double>(b.size());
  double gaps = 0;
  Phase sum = b[0];
  for (std::size_t k = 1; k < b.size(); ++k) {
    gaps += cos_of_gap(b[k - 1], b[k]);
    sum.re += b[k].re;
    sum.im += b[k].im;
  }
  return {gaps / (n - 1),
          (gaps + cos_of_gap(b.back(), b.front())) / n,
          std::sqrt(sum.re * sum.re + sum.im * sum.im) / n,
          {sum.re / n, sum.im / n}};
}

/// Of a grain with N bonds: each goes to the place that the number of those before it gives, without a branch, as
/// branches on random angles cost more than all else here.
template <std::size_t N>
GrainOrder order_of_few(const Bond* b) {
  std::array<std::size_t, N> place{};
  for (std::size_t k = 1; k < N; ++k)
    for (std::size_t m = 0; m < k; ++m) {
      const bool before = b[k].order < b[m].order;
      place[m] += before;
      place[k] += !before;
    }
  std::array<Phase, N> sorted;  // whole phases, written as they will be read
  for (std::size_t k = 0; k < N; ++k) sorted[place[k]] = b[k].six;
  return order_of(sorted);
}

GrainOrder order_of_many(std::span<Bond> b) {
  std::stable_sort(b.begin(), b.end(), [](const Bond& x, const Bond& y) { return x.order < y.order; });
  std::vector<Phase> sorted;
  for (const Bond& bond : b) sorted.push_back(bond.six);
  return order_of(sorted);
}

/// Grains with N bonds, for one N after the other: so every loop has a known length.
template <std::size_t N>
void add_grains(const std::vector<std::uint32_t>& grains, const BondList& list, std::vector<GrainOrder>& orders) {
  for (const std::uint32_t i : grains) orders[i] = order_of_few<N>(list.bonds.data() + list.begin[i]);
}

}  // namespace

BondOrder bond_order(const Packing& packing, const Bonds& pairs) {
  const std::size_t grains = pairs.grains.size();
  if (grains == 0 || packing.dimension != 2) return {};
  BondList list = list_bonds(packing, pairs);
  std::array<std::vector<std::uint32_t>, 8> with;  // grains by number of bonds; 7: so many or more
  for (std::uint32_t i = 0; i < grains; ++i) with[std::min(pairs.grains[i], 7u)].push_back(i);
  std::vector<GrainOrder> orders(grains);
  add_grains<2>(with[2], list, orders);
  add_grains<3>(with[3], list, orders);
  add_grains<4>(with[4], list, orders);
  add_grains<5>(with[5], list, orders);
  add_grains<6>(with[6], list, orders);
  for (const std::uint32_t i : with[7]) orders[i] = order_of_many({list.bonds.data() + list.begin[i], pairs.grains[i]});
  GrainOrder sum;
  for (const GrainOrder& g : orders) {
    sum.printed += g.printed;
    sum.closed += g.closed;
    sum.local += g.local;
    sum.mean.re += g.mean.re;
    sum.mean.im += g.mean.im;
  }
  const auto n = static_cast<double>(grains);
  return {sum.printed / n, sum.closed / n, sum.local / n,
          std::sqrt(sum.mean.re * sum.mean.re + sum.mean.im * sum.mean.im) / n};
}

Measure bond_order_measure() {
  return frame_measure({"bond_order", "six-fold bond orientation",
                        "psi6 = <(1/N) sum_j (N_b - 1)^-1 sum_k cos 6 theta_k>, theta_k the gaps between consecutive "
                        "contacts of a grain "
                        "sorted in [-pi, pi). As printed it has no phases that cancel: 1 for a hexagonal lattice, but "
                        "-1 for a square one "
                        "and +1 for a straight chain. psi6_local and psi6_global are the usual order parameters. A "
                        "grain with one bond or "
                        "none contributes 0; all are 0 in three dimensions.",
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
