#include "jamscape/dem/cluster_list.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace jam {
namespace {

/// Bodies sorted into cubic cells, as index ranges.
struct BodyGrid {
  Vec3 lo{1e300, 1e300, 1e300};
  double inverse = 0;
  std::array<int, 3> cells{1, 1, 1};
  std::vector<std::uint32_t> first, body;

  BodyGrid(const ClusterState& s, double least) {
    Vec3 hi{-1e300, -1e300, -1e300};
    for (std::size_t k = 0; k < s.count(); ++k)
      for (int c = 0; c < 3; ++c) {
        lo[c] = std::min(lo[c], s.row(k)[c]);
        hi[c] = std::max(hi[c], s.row(k)[c]);
      }
    // A few bodies far away from the others must not call for more cells than there are bodies to sort.
    const double most = 8.0 * static_cast<double>(s.count()) + 64;
    double total = 0;
    for (double width = least; total == 0 || total > most; width *= 1.5) {
      inverse = 1 / width;
      total = 1;
      for (int c = 0; c < 3; ++c) total *= std::floor((hi[c] - lo[c]) * inverse) + 1;
    }
    for (int c = 0; c < 3; ++c)
      cells[static_cast<std::size_t>(c)] = static_cast<int>(std::floor((hi[c] - lo[c]) * inverse)) + 1;
    std::vector<std::uint32_t> cell(s.count());
    first.assign(static_cast<std::size_t>(total) + 1, 0);
    for (std::size_t k = 0; k < s.count(); ++k) ++first[(cell[k] = index(coordinates(s.row(k)))) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    body = std::vector<std::uint32_t>(s.count());
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (std::size_t k = 0; k < s.count(); ++k) body[next[cell[k]]++] = static_cast<std::uint32_t>(k);
  }

  std::array<int, 3> coordinates(const double* x) const {
    std::array<int, 3> at;
    for (std::size_t c = 0; c < 3; ++c)
      at[c] = std::clamp(static_cast<int>((x[c] - lo[static_cast<int>(c)]) * inverse), 0, cells[c] - 1);
    return at;
  }
  std::uint32_t index(const std::array<int, 3>& at) const {
    return static_cast<std::uint32_t>((at[2] * cells[1] + at[1]) * cells[0] + at[0]);
  }
};

/// The bodies after `a` in memory whose circumscribed spheres come nearer to that of `a` than their skins.
void find_partners(const ClusterState& s, const BodyGrid& grid, std::uint32_t a, std::vector<std::uint32_t>& found) {
  found.clear();
  const Vec3 x = vec3(s.row(a));
  const auto at = grid.coordinates(s.row(a));
  const auto from = [&](std::size_t c) { return std::max(at[c] - 1, 0); };
  const auto to = [&](std::size_t c) { return std::min(at[c] + 1, grid.cells[c] - 1); };
  for (int z = from(2); z <= to(2); ++z)
    for (int y = from(1); y <= to(1); ++y) {
      const std::uint32_t begin = grid.first[grid.index({from(0), y, z})],
                          end = grid.first[grid.index({to(0), y, z}) + 1];
      for (std::uint32_t q = begin; q < end; ++q) {
        const std::uint32_t b = grid.body[q];
        if (b <= a) continue;
        const Vec3 d = vec3(s.row(b)) - x;
        const double reach = s.radius[a] + s.radius[b] + s.skin[a] + s.skin[b];
        if (dot(d, d) < reach * reach) found.push_back(b);
      }
    }
  std::sort(found.begin(), found.end());
}

/// Whether an arm comes nearer to the circumscribed sphere of another body than `skin`.
bool near_body(const double* arm, const Vec3& centre, double radius, double skin) {
  const Segment<double> axis = axis_of(arm);
  const Vec3 d = centre - axis.centre;
  const double s = clamp_to(dot(d, axis.direction), axis.half_length), reach = radius + arm[3] + skin;
  const Vec3 apart = d - s * axis.direction;
  return dot(apart, apart) < reach * reach;
}

/// Appends the near pairs of arms of i and j.
void append_arms(ArmPairs& list, const ClusterState& s, std::uint32_t i, std::uint32_t j) {
  const double skin = s.skin[i] + s.skin[j];
  const double mi = s.row(i)[ClusterRow::mass], mj = s.row(j)[ClusterRow::mass];
  const Vec3 xi = vec3(s.row(i)), xj = vec3(s.row(j));
  for (std::uint32_t a = s.first_arm[i]; a < s.first_arm[i + 1]; ++a) {
    if (!near_body(s.arm(a), xj, s.radius[j], skin)) continue;
    for (std::uint32_t b = s.first_arm[j]; b < s.first_arm[j + 1]; ++b) {
      if (!near_body(s.arm(b), xi, s.radius[i], skin)) continue;
      const double reach = s.arm(a)[3] + s.arm(b)[3] + skin;
      if (closest_points(axis_of(s.arm(a)), axis_of(s.arm(b))).distance2 >= reach * reach) continue;
      list.i.push_back(i), list.j.push_back(j);
      list.arm_i.push_back(a), list.arm_j.push_back(b);
      list.mbar.push_back(mi * mj / (mi + mj));
    }
  }
}

}  // namespace

void KeptSprings::put(std::uint32_t first, std::uint32_t second, const Vec3& spring) {
  put_.push_back({first, second, spring});
  ++start_[first + 1];
}

void KeptSprings::sort() {
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  sorted_.resize(put_.size());
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  for (const Entry& e : put_) sorted_[next[e.first]++] = e;
}

const Vec3* KeptSprings::find(std::uint32_t first, std::uint32_t second) const {
  for (std::uint32_t q = start_[first]; q < start_[first + 1]; ++q)
    if (sorted_[q].second == second) return &sorted_[q].spring;
  return nullptr;
}

ArmPairs list_arm_pairs(const ClusterState& s, const ArmPairs& old, const std::vector<std::uint32_t>& old_arm_id) {
  ArmPairs list;
  if (s.count() == 0) return list;
  double widest = 0;
  for (std::size_t k = 0; k < s.count(); ++k) widest = std::max(widest, s.radius[k] + s.skin[k]);
  const BodyGrid grid(s, 2 * widest);
  std::vector<std::uint32_t> partners;
  for (std::uint32_t a = 0; a < s.count(); ++a) {
    find_partners(s, grid, a, partners);
    for (const std::uint32_t b : partners) s.id[a] < s.id[b] ? append_arms(list, s, a, b) : append_arms(list, s, b, a);
  }
  list.count = list.i.size();
  const auto far = static_cast<std::uint32_t>(s.arm_count());
  while (list.size() % block) {
    list.i.push_back(0), list.j.push_back(0);
    list.arm_i.push_back(far), list.arm_j.push_back(far + 1);
    list.mbar.push_back(1);
  }

  KeptSprings kept(s.arm_count());
  for (std::size_t k = 0; k < old.count; ++k)
    if (old.holds(k)) kept.put(old_arm_id[old.arm_i[k]], old_arm_id[old.arm_j[k]], old.spring(k));
  kept.sort();
  list.springs.assign(4 * list.size(), 0.0);
  list.held.assign(list.size() / block, 0);
  for (std::size_t k = 0; k < list.count; ++k)
    if (const Vec3* spring = kept.find(s.arm_id[list.arm_i[k]], s.arm_id[list.arm_j[k]])) {
      for (std::size_t c = 0; c < 3; ++c) list.springs[4 * k + c] = (*spring)[static_cast<int>(c)];
      list.held[k / block] = static_cast<std::uint8_t>(list.held[k / block] | 1u << (k % block));
    }
  return list;
}

}  // namespace jam
