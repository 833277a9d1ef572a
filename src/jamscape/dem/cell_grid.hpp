// Bodies sorted into cubic cells: what the search for pairs and the spatial order look at.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "jamscape/base/error.hpp"
#include "jamscape/dem/periodic.hpp"
#include "jamscape/dem/rows.hpp"

namespace jam {

/// Bodies are put back into spatial order with the first of so many lists of pairs.
inline constexpr std::int64_t lists_per_order = 16;

/// Cells of at least a given width, as index ranges. Throws a usage error where a periodic box is less than three cells
/// wide.
template <int D>
struct CellGrid {
  std::array<double, D> lo{}, inverse{};
  std::array<int, D> cells{};
  std::array<bool, D> periodic{};
  std::vector<std::uint32_t> first;
  /// Of the bodies, by cell, then by index; `block` more than there are can be read.
  std::array<Aligned<double>, D> x;
  Aligned<double> radius;
  Aligned<std::uint32_t> body;

  /// `bodies` has count(), and for each body k row(k), which begins with the position, and radius(k).
  template <class Points>
  CellGrid(const Points& bodies, const Periodic<D>& box, double least) {
    for (int c = 0; c < D; ++c) {
      const auto e = static_cast<std::size_t>(c);
      double length = box.length[e];
      periodic[e] = length > 0;
      if (periodic[e]) {
        lo[e] = box.lo[e];
      } else {
        double hi = lo[e] = bodies.row(0)[c];
        for (std::size_t k = 1; k < bodies.count(); ++k) {
          lo[e] = std::min(lo[e], bodies.row(k)[c]);
          hi = std::max(hi, bodies.row(k)[c]);
        }
        length = std::max(hi - lo[e], least);
      }
      cells[e] = std::clamp(static_cast<int>(length / least), 1, 4096);
      if (periodic[e] && cells[e] < 3)
        throw usage_error("the periodic box is less than three grain diameters wide", {}, "more grains, or walls");
      inverse[e] = cells[e] / length;
    }
    const std::size_t total = std::accumulate(cells.begin(), cells.end(), std::size_t{1},
                                              [](std::size_t a, int b) { return a * static_cast<std::size_t>(b); });
    first.assign(total + 1, 0);
    std::vector<std::uint32_t> cell(bodies.count());
    for (std::size_t k = 0; k < bodies.count(); ++k) ++first[(cell[k] = index(coordinates(bodies.row(k)))) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    for (auto& along : x) along.resize(bodies.count() + block);
    radius.resize(bodies.count() + block), body.resize(bodies.count() + block);
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (std::size_t k = 0; k < bodies.count(); ++k) {
      const std::size_t at = next[cell[k]]++;
      for (std::size_t e = 0; e < D; ++e) x[e][at] = bodies.row(k)[e];
      radius[at] = bodies.radius(k), body[at] = static_cast<std::uint32_t>(k);
    }
  }

  std::array<int, D> coordinates(const double* row) const {
    std::array<int, D> at;
    for (std::size_t e = 0; e < D; ++e)
      at[e] = std::clamp(static_cast<int>((row[e] - lo[e]) * inverse[e]), 0, cells[e] - 1);
    return at;
  }
  std::uint32_t index(const std::array<int, D>& at) const {
    std::size_t n = 0;
    for (std::size_t e = D; e-- > 0;) n = n * static_cast<std::size_t>(cells[e]) + static_cast<std::size_t>(at[e]);
    return static_cast<std::uint32_t>(n);
  }
};

}  // namespace jam
