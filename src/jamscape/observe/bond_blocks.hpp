// The bonds of all grains of a packing in the plane, in blocks of eight grains with equally many bonds for
// bond_lanes.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "jamscape/observe/bond_lanes.hpp"

namespace jam {

class BondBlocks {
 public:
  /// From the number of bonds of each grain.
  explicit BondBlocks(const std::vector<std::uint32_t>& bonds);

  /// The direction of a grain's next bond; it must get as many as it was announced with.
  void add(std::size_t grain, double x, double y) {
    LaneDirections& to = directions_[next_[grain]++];
    to.x[lane(grain)] = x;
    to.y[lane(grain)] = y;
  }

  /// Of all blocks: `printed` and `closed` are 0 with fewer than two bonds, all without any. Every bond must be there.
  std::unique_ptr<LaneOrders[]> orders() const;
  /// Where a grain is found in orders().
  std::size_t block(std::size_t grain) const { return slot_[grain] / bond_lanes; }
  std::size_t lane(std::size_t grain) const { return slot_[grain] % bond_lanes; }

 private:
  struct Run {                           // of blocks whose grains have equally many bonds
    std::uint32_t blocks, first, begin;  // number; first block and its first bond
  };

  std::vector<Run> runs_;                         // by number of bonds
  std::vector<std::uint32_t> slot_;               // of each grain: bond_lanes * block + lane
  std::vector<std::uint32_t> next_;               // of each grain: where its next bond goes
  std::unique_ptr<LaneDirections[]> directions_;  // 0 in lanes without a grain
};

}  // namespace jam
