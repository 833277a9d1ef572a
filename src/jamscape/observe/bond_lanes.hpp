// Six-fold orientation around eight grains with equally many bonds at once, in vector registers (Highway picks the
// width that the processor has). Every width takes the same exact element-wise operations in the same order, so all of
// them give the same bits.
#pragma once

#include <cstddef>
#include <cstdint>

namespace jam {

constexpr std::uint32_t bond_lanes = 8;

/// A direction of each of eight grains.
struct alignas(64) LaneDirections {
  double x[bond_lanes], y[bond_lanes];
};

/// A bond of each: what increases with its angle in [-pi, pi), and exp(6 i theta).
struct alignas(64) LaneBonds {
  double order[bond_lanes], re[bond_lanes], im[bond_lanes];
};

/// What each adds to the sums of bond_order.hpp: the mean over its gaps without and with the last one, the size and the
/// parts of its mean phase.
struct alignas(64) LaneOrders {
  double printed[bond_lanes], closed[bond_lanes], local[bond_lanes], re[bond_lanes], im[bond_lanes];
};

/// Eight grains a block, `bonds` > 1 directions each, block after block. `sorted` has room for the bonds of one block.
/// Sorting is by insertion: about bonds^2/2 steps a block.
void order_blocks(std::size_t bonds, std::size_t blocks, const LaneDirections* directions, LaneBonds* sorted,
                  LaneOrders* orders);

}  // namespace jam
