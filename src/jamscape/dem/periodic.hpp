// A periodic box and its images.
#pragma once

#include <array>
#include <cstdint>

#include "jamscape/dem/rows.hpp"

namespace jam {

/// The box of a periodic simulation; lengths 0 where it is not periodic.
template <int D>
struct Periodic {
  std::array<double, D> lo{}, length{};
};

/// The box itself and its neighbours: 3^D.
template <int D>
constexpr std::uint32_t images = D == 2 ? 9 : 27;
/// The one that is no shift.
template <int D>
constexpr std::uint32_t no_shift = (images<D> - 1) / 2;

/// Rows of four doubles, one for each image of the box.
template <int D>
Aligned<double> image_shifts(const Periodic<D>& box);

/// The image numbers (-1, 0, 1 in each direction) of a row of image_shifts().
template <int D>
constexpr std::array<std::int8_t, 3> image_of(std::uint32_t shift) {
  std::array<std::int8_t, 3> image{};
  for (std::size_t e = 0; e < D; ++e, shift /= 3) image[e] = static_cast<std::int8_t>(static_cast<int>(shift % 3) - 1);
  return image;
}

}  // namespace jam
