// Disjoint sets in which the smallest member leads: number the members by age, oldest first, and a merge is the elder
// rule of persistence (the younger set's leader dies).
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

  Merge unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (b < a) std::swap(a, b);
    parent_[b] = a;
    return {a, b};
  }

  std::uint32_t members() const { return static_cast<std::uint32_t>(parent_.size()); }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace jam
