#include "jamscape/observe/bond_blocks.hpp"

#include <algorithm>

namespace jam {

BondBlocks::BondBlocks(const std::vector<std::uint32_t>& bonds) : slot_(bonds.size()), next_(bonds.size()) {
  std::vector<std::uint32_t> grains;  // with so many bonds; later the slot of the next of them
  for (const std::uint32_t n : bonds) {
    if (n >= grains.size()) grains.resize(n + 1);
    ++grains[n];
  }
  std::uint32_t blocks = 0, size = 0;
  for (std::uint32_t n = 0; n < grains.size(); ++n) {
    runs_.push_back({(grains[n] + bond_lanes - 1) / bond_lanes, blocks, size});
    grains[n] = blocks * bond_lanes;
    blocks += runs_[n].blocks;
    size += runs_[n].blocks * n;
  }
  directions_ = std::make_unique_for_overwrite<LaneDirections[]>(size);
  for (std::uint32_t n = 0; n < grains.size(); ++n)  // only the last block of a run has lanes without a grain
    if (runs_[n].blocks > 0) std::fill_n(&directions_[runs_[n].begin + (runs_[n].blocks - 1) * n], n, LaneDirections{});
  for (std::size_t i = 0; i < bonds.size(); ++i) {
    slot_[i] = grains[bonds[i]]++;
    const Run& run = runs_[bonds[i]];
    next_[i] = run.begin + (slot_[i] / bond_lanes - run.first) * bonds[i];
  }
}

std::unique_ptr<LaneOrders[]> BondBlocks::orders() const {
  const std::size_t blocks = runs_.empty() ? 0 : runs_.back().first + runs_.back().blocks;
  auto orders = std::make_unique_for_overwrite<LaneOrders[]>(blocks);
  std::vector<LaneBonds> sorted(runs_.size());
  for (std::size_t n = 0; n < runs_.size(); ++n) {
    const Run& run = runs_[n];
    if (n == 0)
      std::fill_n(&orders[run.first], run.blocks, LaneOrders{});
    else
      order_blocks(n, run.blocks, &directions_[run.begin], sorted.data(), &orders[run.first]);
    for (std::size_t b = 0; n == 1 && b < run.blocks; ++b) {  // no gap between bonds
      std::fill_n(orders[run.first + b].printed, bond_lanes, 0.0);
      std::fill_n(orders[run.first + b].closed, bond_lanes, 0.0);
    }
  }
  return orders;
}

}  // namespace jam
