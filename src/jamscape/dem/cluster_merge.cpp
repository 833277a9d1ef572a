#include "jamscape/dem/cluster_merge.hpp"

#include <algorithm>

#include "jamscape/dem/cluster_contact.hpp"

namespace jam {
namespace {

std::uint8_t bit_of(std::size_t k) { return static_cast<std::uint8_t>(1u << (k % block)); }

}  // namespace

std::vector<Merged> merge_duplicates(const ClusterState& b, const ArmPairs& p, const PressRule& rule, ArmContacts& c) {
  struct Candidate {
    std::size_t contact;
    double overlap, radius;
    Vec3 point;
  };
  std::vector<Merged> merged;
  std::vector<Candidate> group;
  std::vector<bool> dropped(c.count, false);
  for (std::size_t from = 0, to = 0; from < c.count; from = to) {
    const auto body = [&](std::size_t k) { return std::pair(p.i[c.pair[k]], p.j[c.pair[k]]); };
    while (to < c.count && body(to) == body(from)) ++to;
    if (to - from < 2) continue;
    group.clear();
    for (std::size_t k = from; k < to; ++k) {
      const double *one = b.arm(p.arm_i[c.pair[k]]), *two = b.arm(p.arm_j[c.pair[k]]);
      const ArmTouch<double> t = touch_arms(rule.parallel, one, two, rule.parallel_sine2);
      group.push_back({k, t.overlap, smaller(one[3], two[3]), t.point});
    }
    std::stable_sort(group.begin(), group.end(),
                     [](const Candidate& x, const Candidate& y) { return x.overlap > y.overlap; });
    for (std::size_t g = 1; g < group.size(); ++g)
      for (std::size_t h = 0; h < g; ++h) {
        if (dropped[group[h].contact] || !(norm(group[g].point - group[h].point) < group[g].radius)) continue;
        dropped[group[g].contact] = true;
        merged.push_back({c.pair[group[g].contact], c.pair[group[h].contact]});
        break;
      }
  }
  std::size_t count = 0;
  for (std::size_t k = 0; k < c.count; ++k) {
    if (dropped[k]) {
      std::uint8_t& bits = c.touching[c.pair[k] / block];
      bits = static_cast<std::uint8_t>(bits & ~bit_of(c.pair[k]));
      continue;
    }
    c.pair[count++] = c.pair[k];
  }
  c.count = count;
  return merged;
}

void hand_over_springs(const std::vector<Merged>& merged, ArmPairs& p) {
  for (const Merged& m : merged) {
    if (!p.holds(m.dropped) || p.holds(m.kept)) continue;
    std::copy_n(p.springs.begin() + 4 * static_cast<std::ptrdiff_t>(m.dropped), 4,
                p.springs.begin() + 4 * static_cast<std::ptrdiff_t>(m.kept));
    std::fill_n(p.springs.begin() + 4 * static_cast<std::ptrdiff_t>(m.dropped), 4, 0.0);
    p.held[m.kept / block] = static_cast<std::uint8_t>(p.held[m.kept / block] | bit_of(m.kept));
    p.held[m.dropped / block] = static_cast<std::uint8_t>(p.held[m.dropped / block] & ~bit_of(m.dropped));
  }
}

}  // namespace jam
