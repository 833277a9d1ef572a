// The bodies near a body.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "jamscape/dem/cell_grid.hpp"

namespace jam {

/// A body near another: its index, the image of the box in which it is near (a row of image_shifts()), whether they
/// touch.
struct FoundBody {
  std::uint32_t j, shift;
  bool touching;
};

/// The bodies after `a` in memory that are nearer than the sum of radii + skin, by neighbouring cell.
template <int D>
class PairSearch {
 public:
  PairSearch(const CellGrid<D>& grid, const Aligned<double>& shifts, double skin)
      : grid_(grid), shifts_(shifts), skin_(skin) {}

  std::span<const FoundBody> operator()(const double* row, std::uint32_t a) {
    count_ = 0;
    const auto at = grid_.coordinates(row);
    bool inside = true;
    for (std::size_t e = 0; e < D; ++e) inside = inside && at[e] > 0 && at[e] + 1 < grid_.cells[e];
    if (inside) {  // cells side by side along the first axis are one range
      const std::uint32_t line = static_cast<std::uint32_t>(grid_.cells[0]);
      const std::uint32_t plane = D == 3 ? line * static_cast<std::uint32_t>(grid_.cells[1]) : 0;
      const std::uint32_t lowest = grid_.index(at) - line - plane;
      for (std::uint32_t z = 0; z < (D == 3 ? 3 : 1); ++z)
        for (std::uint32_t y = 0; y < 3; ++y) {
          const std::uint32_t c = lowest + y * line + z * plane;
          look(row, a, grid_.first[c - 1], grid_.first[c + 2], no_shift<D>);
        }
    } else {
      for (std::uint32_t s = 0; s < images<D>; ++s) {
        std::array<int, D> cell = neighbour(at, s);
        std::uint32_t shift = 0, weight = 1;
        bool outside = false;
        for (std::size_t e = 0; e < D; ++e, weight *= 3) {
          std::uint32_t image = 1;
          if (cell[e] < 0 || cell[e] >= grid_.cells[e]) {
            if (!grid_.periodic[e]) outside = true;
            image = cell[e] < 0 ? 0 : 2;
            cell[e] += cell[e] < 0 ? grid_.cells[e] : -grid_.cells[e];
          }
          shift += weight * image;
        }
        if (outside) continue;
        const std::uint32_t c = grid_.index(cell);
        look(row, a, grid_.first[c], grid_.first[c + 1], shift);
      }
    }
    return {found_.data(), count_};
  }

 private:
  static std::array<int, D> neighbour(std::array<int, D> cell, std::uint32_t s) {
    const auto step = image_of<D>(s);
    for (std::size_t e = 0; e < D; ++e) cell[e] += step[e];
    return cell;
  }
  /// Every candidate is written, and the next one over it unless it was near: no branch to guess.
  void look(const double* x, std::uint32_t a, std::uint32_t from, std::uint32_t to, std::uint32_t shift) {
    if (found_.size() < count_ + (to - from)) found_.resize(2 * (count_ + (to - from)));
    FoundBody* out = found_.data();
    const double* moved = shifts_.data() + 4 * shift;
    std::size_t n = count_;
    for (std::uint32_t q = from; q < to; ++q) {
      const Placed<D>& p = grid_.placed[q];
      double r2 = 0;
      for (std::size_t e = 0; e < D; ++e) {
        const double d = (p.x[e] + moved[e]) - x[e];
        r2 += d * d;
      }
      const double reach = x[Row<D>::radius] + p.radius, far = reach + skin_;
      out[n] = {p.body, shift, r2 < reach * reach};
      n += static_cast<std::size_t>(r2 < far * far) & static_cast<std::size_t>(p.body > a);
    }
    count_ = n;
  }

  const CellGrid<D>& grid_;
  const Aligned<double>& shifts_;
  double skin_;
  std::vector<FoundBody> found_;
  std::size_t count_ = 0;
};

}  // namespace jam
