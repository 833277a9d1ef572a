#include "jamscape/dem/cluster_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "jamscape/dem/cluster_kernel.hpp"
#include "jamscape/dem/pair_search.hpp"

namespace jam {
namespace {

/// Bodies as the spheres around them and their skins.
struct Spheres {
  const ClusterState& bodies;

  std::size_t count() const { return bodies.count(); }
  const double* row(std::size_t k) const { return bodies.row(k); }
  double radius(std::size_t k) const { return bodies.radius[k] + bodies.skin[k]; }
};

/// Of cells of at least that width. A few bodies far away from the others must not call for more cells than there are
/// bodies to sort.
double cell_width(const ClusterState& s, double least) {
  Vec3 lo{1e300, 1e300, 1e300}, hi{-1e300, -1e300, -1e300};
  for (std::size_t k = 0; k < s.count(); ++k)
    for (int c = 0; c < 3; ++c) {
      lo[c] = std::min(lo[c], s.row(k)[c]);
      hi[c] = std::max(hi[c], s.row(k)[c]);
    }
  const double most = 8.0 * static_cast<double>(s.count()) + 64;
  const auto cells = [&](double width) {
    double total = 1;
    for (int c = 0; c < 3; ++c) total *= std::floor((hi[c] - lo[c]) / width) + 1;
    return total;
  };
  double width = least;
  while (cells(width) > most) width *= 1.5;
  return width;
}

/// Pairs of arms of near bodies; those that are near themselves go to the list, in order.
class ArmSearch {
 public:
  ArmSearch(const ClusterState& bodies, const ClusterKernels& kernels, ArmPairs& list)
      : s_(bodies), kernels_(kernels), list_(list), far_(static_cast<std::uint32_t>(bodies.arm_count())) {}

  /// All arms of i with all arms of j.
  void look(std::uint32_t i, std::uint32_t j) {
    for (std::uint32_t a = s_.first_arm[i]; a < s_.first_arm[i + 1]; ++a)
      for (std::uint32_t b = s_.first_arm[j]; b < s_.first_arm[j + 1]; ++b) {
        arm_i_[count_] = a, arm_j_[count_] = b, skin_[count_] = s_.skin[i] + s_.skin[j];
        if (++count_ == room) sift();
      }
  }
  /// Takes the near ones of what has been looked at into the list.
  void sift() {
    const std::size_t blocks = (count_ + block - 1) / block * block;
    for (std::size_t q = count_; q < blocks; ++q) arm_i_[q] = far_, arm_j_[q] = far_ + 1, skin_[q] = 0;
    const std::size_t found =
        kernels_.near({s_.arms.data(), arm_i_.data(), arm_j_.data(), skin_.data(), blocks, near_.data()});
    for (std::size_t f = 0; f < found; ++f) {
      const std::uint32_t a = arm_i_[near_[f]], b = arm_j_[near_[f]], i = s_.arm_body[a], j = s_.arm_body[b];
      const double mi = s_.row(i)[ClusterRow::mass], mj = s_.row(j)[ClusterRow::mass];
      list_.i.push_back(i), list_.j.push_back(j);
      list_.arm_i.push_back(a), list_.arm_j.push_back(b);
      list_.mbar.push_back(mi * mj / (mi + mj));
    }
    count_ = 0;
  }

 private:
  static constexpr std::size_t room = 64 * block;

  const ClusterState& s_;
  const ClusterKernels& kernels_;
  ArmPairs& list_;
  const std::uint32_t far_;
  std::size_t count_ = 0;
  alignas(64) std::array<std::uint32_t, room> arm_i_, arm_j_;
  alignas(64) std::array<std::uint32_t, room + block> near_;
  alignas(64) std::array<double, room> skin_;
};

}  // namespace

void SpringsByNumber::put(std::uint32_t first, std::uint32_t second, const Vec3& spring) {
  put_.push_back({first, second, spring});
  ++start_[first + 1];
}

void SpringsByNumber::sort() {
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  sorted_.resize(put_.size());
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  for (const Entry& e : put_) sorted_[next[e.first]++] = e;
}

const Vec3* SpringsByNumber::find(std::uint32_t first, std::uint32_t second) const {
  for (std::uint32_t q = start_[first]; q < start_[first + 1]; ++q)
    if (sorted_[q].second == second) return &sorted_[q].spring;
  return nullptr;
}

ArmPairs list_arm_pairs(const ClusterState& s, const ArmPairs& old, const std::vector<std::uint32_t>& old_arm_id,
                        const ClusterKernels& kernels) {
  ArmPairs list;
  if (s.count() == 0) return list;
  const Spheres spheres{s};
  double widest = 0;
  for (std::size_t k = 0; k < s.count(); ++k) widest = std::max(widest, spheres.radius(k));
  const Periodic<3> open{};
  const Aligned<double> shifts = image_shifts(open);
  const CellGrid<3> grid(spheres, open, cell_width(s, 2 * widest));
  PairSearch<3> search(grid, shifts, 0, best_kernels());  // all kernels find the same
  ArmSearch arms(s, kernels, list);
  std::vector<std::uint32_t> partners;
  for (std::uint32_t a = 0; a < s.count(); ++a) {
    const double* x = s.row(a);
    const double sphere[] = {x[0], x[1], x[2], spheres.radius(a)};
    partners.resize(search(sphere, a));
    for (std::size_t q = 0; q < partners.size(); ++q) partners[q] = search[q].j;
    std::sort(partners.begin(), partners.end());
    for (const std::uint32_t b : partners) s.id[a] < s.id[b] ? arms.look(a, b) : arms.look(b, a);
  }
  arms.sift();
  list.count = list.i.size();
  const auto far = static_cast<std::uint32_t>(s.arm_count());
  while (list.size() % block) {
    list.i.push_back(0), list.j.push_back(0);
    list.arm_i.push_back(far), list.arm_j.push_back(far + 1);
    list.mbar.push_back(1);
  }

  SpringsByNumber kept(s.arm_count());
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
