#include "jamscape/dem/bodies.hpp"

#include <algorithm>
#include <numeric>

namespace jam {
namespace {

template <class Array>
void permute(Array& values, std::size_t per_body, const std::vector<std::uint32_t>& order) {
  if (values.empty()) return;
  const Array old(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(order.size() * per_body));
  for (std::size_t k = 0; k < order.size(); ++k)
    std::copy_n(old.begin() + static_cast<std::ptrdiff_t>(order[k] * per_body), per_body,
                values.begin() + static_cast<std::ptrdiff_t>(k * per_body));
}

}  // namespace

template <int D>
void Bodies<D>::resize(std::size_t grain_count, std::size_t bead_count, std::size_t parts, bool with_derivatives) {
  using R = Row<D>;
  grains = grain_count;
  beads = bead_count;
  const std::size_t all = count() + 2 * parts;
  rows.assign(all * R::stride, 0.0);
  forces.assign(all * R::force_stride, 0.0);
  inverse.assign(all * 2, 0.0);
  derivatives.assign(with_derivatives ? all * 12 * R::motions : 0, 0.0);
  calm.assign(with_derivatives ? all : 0, 0);
  id.resize(grains);
  std::iota(id.begin(), id.end(), 0u);
  mass.assign(grains, 0.0);
  species.assign(grains, 0);
  for (std::size_t part = 0; part < parts; ++part) {
    row(nobody(part))[0] = 1e9;
    row(nobody(part) + 1)[0] = 2e9;
  }
}

template <int D>
void Bodies<D>::reorder(const std::vector<std::uint32_t>& order) {
  permute(rows, Row<D>::stride, order);
  permute(forces, Row<D>::force_stride, order);
  permute(inverse, 2, order);
  permute(derivatives, 12 * Row<D>::motions, order);
  permute(calm, 1, order);
  permute(id, 1, order);
  permute(mass, 1, order);
  permute(species, 1, order);
}

template struct Bodies<2>;
template struct Bodies<3>;

}  // namespace jam
