#include "jamscape/observe/bond_blocks.hpp"

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
  directions_.resize(size);
  for (std::size_t i = 0; i < bonds.size(); ++i) {
    slot_[i] = grains[bonds[i]]++;
    const Run& run = runs_[bonds[i]];
    next_[i] = run.begin + (slot_[i] / bond_lanes - run.first) * bonds[i];
  }
}

std::vector<LaneOrders> BondBlocks::orders() const {
  std::vector<LaneOrders> orders(runs_.empty() ? 0 : runs_.back().first + runs_.back().blocks);
  std::vector<LaneBonds> sorted(runs_.size());
  for (std::size_t n = 2; n < runs_.size(); ++n)
    order_blocks(n, runs_[n].blocks, &directions_[runs_[n].begin], sorted.data(), &orders[runs_[n].first]);
  return orders;
}

}  // namespace jam
