#include "jamscape/dem/periodic.hpp"

namespace jam {

template <int D>
Aligned<double> image_shifts(const Periodic<D>& box) {
  Aligned<double> rows(images<D> * 4, 0.0);
  for (std::uint32_t s = 0; s < images<D>; ++s) {
    const auto image = image_of<D>(s);
    for (std::size_t e = 0; e < D; ++e) rows[4 * s + e] = image[e] * box.length[e];
  }
  return rows;
}

template Aligned<double> image_shifts<2>(const Periodic<2>&);
template Aligned<double> image_shifts<3>(const Periodic<3>&);

}  // namespace jam
