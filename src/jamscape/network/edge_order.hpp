// Edges by decreasing weight, equal weights by increasing index: the order of every sweep from strong to weak.
//
// Cost: three streaming passes over eight bytes an edge (radix sort of the weight's leading 32 bits within its range,
// then repair of the few that agree in them), so about linear; sixteen bytes of memory an edge.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace jam {

class EdgeOrder {
 public:
  /// Weights must be finite. Keeps its memory between calls.
  void sort(std::span<const double> weight);

  std::size_t size() const { return items_.size(); }
  /// The edge at place `rank`.
  std::uint32_t edge(std::size_t rank) const { return static_cast<std::uint32_t>(items_[rank]); }
  /// Whether the edge at `rank` may weigh as much as the one before it. False is certain; true must be checked.
  bool may_tie_with_previous(std::size_t rank) const { return items_[rank] >> 32 == items_[rank - 1] >> 32; }

 private:
  std::vector<std::uint64_t> items_, spare_;  // leading bits of the weight, complemented | edge
};

/// The same as a plain list.
std::vector<std::uint32_t> edges_by_decreasing_weight(std::span<const double> weight);

}  // namespace jam
