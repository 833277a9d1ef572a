// Edges by decreasing weight, equal weights by increasing index: the order of every sweep from strong to weak.
//
// Cost: two or three streaming passes over eight bytes an edge (radix sort of the weight's leading bits within its
// range, then repair of the few that agree in them), so about linear; sixteen bytes of memory an edge.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace jam {

class EdgeOrder {
 public:
  /// Weights must be finite. Keeps its memory between calls.
  void sort(std::span<const double> weight);

  std::size_t size() const { return items_.size(); }
  /// The edge at place `rank`, and its weight.
  std::uint32_t edge(std::size_t rank) const { return static_cast<std::uint32_t>(items_[rank]); }
  double weight(std::size_t rank) const { return std::bit_cast<double>(spare_[rank]); }

 private:
  template <unsigned passes>
  void sort_leading_bits(std::span<const double> weight);

  std::vector<std::uint64_t> items_;  // leading bits of the weight, complemented | edge
  std::vector<std::uint64_t>
      spare_;  // the other half of the sort; then weights by rank, so that sweeps read in sequence
};

/// The same as a plain list.
std::vector<std::uint32_t> edges_by_decreasing_weight(std::span<const double> weight);

}  // namespace jam
