#include "jamscape/observe/bond_order.hpp"

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

Bond bond(double x, double y) {
  const double re2 = x * x - y * y, im2 = 2 * x * y;
  const double re3 = re2 * x - im2 * y, im3 = re2 * y + im2 * x;
  const bool lower = y < 0 || (y == 0 && x < 0);
  return {lower ? x - 1 : 1 - x, {re3 * re3 - im3 * im3, 2 * re3 * im3}};
}

double cos_of_gap(const Bond& a, const Bond& b) { return a.six.re * b.six.re + a.six.im * b.six.im; }

void sort_bonds(std::span<Bond> b) {  // a handful: insertion
  for (std::size_t k = 1; k < b.size(); ++k) {
    const Bond moved = b[k];
    std::size_t at = k;
    for (; at > 0 && moved.order < b[at - 1].order; --at) b[at] = b[at - 1];
    b[at] = moved;
  }
}

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
    list.bonds[next[packing.contacts.i[c]]++] = bond(n[0], n[1]);
    list.bonds[next[static_cast<std::size_t>(packing.contacts.j[c])]++] = bond(-n[0], -n[1]);
  }
  return list;
}

}  // namespace

BondOrder bond_order(const Packing& packing, const Bonds& pairs) {
  BondOrder sum;
  const std::size_t grains = pairs.grains.size();
  if (grains == 0 || packing.dimension != 2) return sum;
  BondList list = list_bonds(packing, pairs);
  Phase all;
  for (std::size_t i = 0; i < grains; ++i) {
    const std::span<Bond> b(list.bonds.data() + list.begin[i], pairs.grains[i]);
    if (b.size() < 2) continue;
    sort_bonds(b);
    const auto n = static_cast<double>(b.size());
    double gaps = 0;
    Phase mean = b[0].six;
    for (std::size_t k = 1; k < b.size(); ++k) {
      gaps += cos_of_gap(b[k - 1], b[k]);
      mean.re += b[k].six.re;
      mean.im += b[k].six.im;
    }
    sum.printed += gaps / (n - 1);
    sum.closed += (gaps + cos_of_gap(b.back(), b.front())) / n;
    sum.local += std::sqrt(mean.re * mean.re + mean.im * mean.im) / n;
    all.re += mean.re / n;
    all.im += mean.im / n;
  }
  const auto n = static_cast<double>(grains);
  return {sum.printed / n, sum.closed / n, sum.local / n, std::sqrt(all.re * all.re + all.im * all.im) / n};
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
