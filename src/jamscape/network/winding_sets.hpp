// Disjoint sets in a periodic box: each member knows in which copy of the box it lies as seen from its leader, so that
// an edge that closes a path tells whether the path winds around the box. Source: Newman and Ziff, Phys. Rev. E 64,
// 016706 (2001), Sec. II.D.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace jam {

/// A copy of the box, counted in box lengths.
using BoxCopy = std::array<std::int32_t, 3>;

class WindingSets {
 public:
  struct Merge {
    std::uint32_t kept, lost;  ///< leaders before the merge; equal when both members were in one set already
    BoxCopy around{};          ///< net winding of the path that was closed; zero where two sets were joined
    bool joined() const { return kept != lost; }
  };

  explicit WindingSets(std::uint32_t members) : parent_(members), copy_(members) {
    for (std::uint32_t i = 0; i < members; ++i) parent_[i] = i;
  }

  /// Joins a to the copy of b that lies `image` boxes away. `older(x, y)`: whether leader x stays leader.
  template <class Older>
  Merge unite(std::uint32_t a, std::uint32_t b, const BoxCopy& image, Older&& older) {
    auto [leader_a, copy_a] = find(a);
    auto [leader_b, copy_b] = find(b);
    const BoxCopy gap = difference(sum(copy_a, image), copy_b);  // of b's leader, as seen from a's
    if (leader_a == leader_b) return {leader_a, leader_a, gap};
    const bool swapped = older(leader_b, leader_a);
    if (swapped) std::swap(leader_a, leader_b);
    parent_[leader_b] = leader_a;
    copy_[leader_b] = swapped ? difference({}, gap) : gap;
    return {leader_a, leader_b, {}};
  }

 private:
  struct Place {
    std::uint32_t leader;
    BoxCopy copy;  // of the member, as seen from the leader
  };

  static BoxCopy sum(const BoxCopy& a, const BoxCopy& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
  static BoxCopy difference(const BoxCopy& a, const BoxCopy& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

  Place find(std::uint32_t a) {  // halves the path on its way
    BoxCopy copy{};
    while (parent_[a] != a) {
      const std::uint32_t up = parent_[a];
      if (parent_[up] != up) {
        copy_[a] = sum(copy_[a], copy_[up]);
        parent_[a] = parent_[up];
      }
      copy = sum(copy, copy_[a]);
      a = parent_[a];
    }
    return {a, copy};
  }

  std::vector<std::uint32_t> parent_;
  std::vector<BoxCopy> copy_;  // of the member, as seen from its parent
};

}  // namespace jam
