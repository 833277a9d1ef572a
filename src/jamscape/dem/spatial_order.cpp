#include <algorithm>
#include <numeric>

#include "jamscape/dem/cell_grid.hpp"
#include "jamscape/dem/pair_list.hpp"

namespace jam {

template <int D>
std::vector<std::uint32_t> spatial_order(const Bodies<D>& bodies) {
  double widest = 0;
  for (std::size_t k = 0; k < bodies.grains; ++k) widest = std::max(widest, bodies.radius(k));
  const CellGrid<D> grid(bodies, Periodic<D>{}, std::max(2 * widest, 1e-300));
  std::vector<std::uint64_t> key(bodies.grains);
  for (std::size_t k = 0; k < bodies.grains; ++k) {
    const auto at = grid.coordinates(bodies.row(k));
    for (int bit = 0; bit < 12; ++bit)
      for (std::size_t e = 0; e < D; ++e)
        key[k] |= static_cast<std::uint64_t>((at[e] >> bit) & 1) << (static_cast<std::size_t>(bit) * D + e);
  }
  std::vector<std::uint32_t> order(bodies.grains);
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key[a] < key[b]; });
  return order;
}

template std::vector<std::uint32_t> spatial_order<2>(const Bodies<2>&);
template std::vector<std::uint32_t> spatial_order<3>(const Bodies<3>&);

}  // namespace jam
