// Disjoint sets whose leader is the oldest member: the elder rule of persistence (of two merging sets, the younger
// leader dies).
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace jam {

class UnionFind {
 public:
  struct Merge {
    std::uint32_t kept, lost;  ///< leaders before the merge; equal when both members were in one set already
    bool joined() const { return kept != lost; }
  };

  UnionFind() = default;
  explicit UnionFind(std::uint32_t members) { reset(members); }

  /// Every member alone again; keeps the memory.
  void reset(std::uint32_t members) {
    parent_.resize(members);
    for (std::uint32_t i = 0; i < members; ++i) parent_[i] = i;
  }

  /// The leader of a's set; shortens the path on its way (so not const).
  std::uint32_t find(std::uint32_t a) {
    while (true) {
      const auto up = parent_[a];
      const auto upper = parent_[up];
      if (up == upper) return up;
      parent_[a] = upper;
      a = upper;
    }
  }

  /// `older(x, y)`: whether leader x outlives leader y.
  template <class Older>
  Merge unite(std::uint32_t a, std::uint32_t b, Older&& older) {
    a = find(a);
    b = find(b);
    if (a == b) return {a, a};
    if (older(b, a)) std::swap(a, b);
    parent_[b] = a;
    return {a, b};
  }

  /// The smaller number is older.
  Merge unite(std::uint32_t a, std::uint32_t b) {
    return unite(a, b, [](std::uint32_t x, std::uint32_t y) { return x < y; });
  }

  /// Asks the cache for a member that find() will need soon.
  void prefetch(std::uint32_t a) const { __builtin_prefetch(&parent_[a], 1); }

  std::uint32_t members() const { return static_cast<std::uint32_t>(parent_.size()); }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace jam
