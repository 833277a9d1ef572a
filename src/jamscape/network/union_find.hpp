// Disjoint sets whose leader is the oldest member: the elder rule of persistence (of two merging sets, the younger
// leader dies).
#pragma once

#include <cstdint>
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
    // Nearly all paths have two steps at most. How many of them no processor could guess, so none is asked.
    const auto up = parent_[a], upper = parent_[up], top = parent_[upper];
    parent_[a] = top;
    if (upper == top) return top;
    for (a = top; parent_[a] != a; a = parent_[a]) parent_[a] = parent_[parent_[a]];
    return a;
  }

  /// `older(x, y)`: whether leader x outlives leader y; false where x = y.
  template <class Older>
  Merge unite(std::uint32_t a, std::uint32_t b, Older&& older) {
    a = find(a);
    b = find(b);
    const bool second = older(b, a);  // false where both are the same
    const auto kept = second ? b : a, lost = second ? a : b;
    parent_[lost] = kept;
    return {kept, lost};
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
