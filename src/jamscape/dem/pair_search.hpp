// The bodies near a body, found among those of the cells around it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "jamscape/dem/cell_grid.hpp"
#include "jamscape/dem/kernel.hpp"

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
  PairSearch(const CellGrid<D>& grid, const Aligned<double>& shifts, double skin, const Kernels& kernels)
      : grid_(grid), kernels_(kernels) {
    query_.skin = skin;
    for (std::size_t e = 0; e < D; ++e) query_.x[e] = grid.x[e].data();
    query_.radius = grid.radius.data(), query_.body = grid.body.data();
    query_.shifts = shifts.data();
  }

  /// Returns how many they are.
  std::size_t operator()(const double* row, std::uint32_t a) {
    count_ = candidates_ = 0;
    const auto at = grid_.coordinates(row);
    bool inside = true;
    for (std::size_t e = 0; e < D; ++e) inside = inside && at[e] > 0 && at[e] + 1 < grid_.cells[e];
    inside ? look_inside(at) : look_everywhere(at);
    if (body_.size() < candidates_ + block) body_.resize(2 * (candidates_ + block)), shift_.resize(body_.size());
    query_.row = row, query_.a = a, query_.ranges = ranges_.data(), query_.range_count = count_;
    return kernels_.near<D>()(query_, {body_.data(), shift_.data()});
  }
  /// The k-th found last.
  FoundBody operator[](std::size_t k) const {
    return {body_[k] & ~NearBodies::touching, shift_[k], (body_[k] & NearBodies::touching) != 0};
  }

 private:
  void look(std::uint32_t from, std::uint32_t to, std::uint32_t shift) {
    ranges_[count_++] = {from, to, shift};
    candidates_ += to - from;
  }
  /// Cells side by side along the first axis are one range.
  void look_inside(const std::array<int, D>& at) {
    const std::uint32_t line = static_cast<std::uint32_t>(grid_.cells[0]);
    const std::uint32_t plane = D == 3 ? line * static_cast<std::uint32_t>(grid_.cells[1]) : 0;
    const std::uint32_t lowest = grid_.index(at) - line - plane;
    for (std::uint32_t z = 0; z < (D == 3 ? 3 : 1); ++z)
      for (std::uint32_t y = 0; y < 3; ++y) {
        const std::uint32_t c = lowest + y * line + z * plane;
        look(grid_.first[c - 1], grid_.first[c + 2], no_shift<D>);
      }
  }
  /// Of a cell at the edge.
  void look_everywhere(const std::array<int, D>& at) {
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
      look(grid_.first[c], grid_.first[c + 1], shift);
    }
  }
  static std::array<int, D> neighbour(std::array<int, D> cell, std::uint32_t s) {
    const auto step = image_of<D>(s);
    for (std::size_t e = 0; e < D; ++e) cell[e] += step[e];
    return cell;
  }

  const CellGrid<D>& grid_;
  const Kernels& kernels_;
  NearQuery query_{};
  std::array<CandidateRange, images<D>> ranges_;
  std::size_t count_ = 0, candidates_ = 0;
  std::vector<std::uint32_t> body_, shift_;
};

}  // namespace jam
