// Bodies sorted into cubic cells: what the search for pairs and the spatial order look at.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "jamscape/base/error.hpp"
#include "jamscape/dem/bodies.hpp"
#include "jamscape/dem/periodic.hpp"

namespace jam {

/// A body as the search for pairs sees it.
template <int D>
struct Placed {
  std::array<double, D> x;
  double radius;
  std::uint32_t body;
};

/// Cells of at least a given width, as index ranges. Throws a usage error where a periodic box is less than three cells
/// wide.
template <int D>
struct CellGrid {
  std::array<double, D> lo{}, inverse{};
  std::array<int, D> cells{};
  std::array<bool, D> periodic{};
  std::vector<std::uint32_t> first;
  std::vector<Placed<D>> placed;  ///< by cell, then by index

  CellGrid(const Bodies<D>& bodies, const Periodic<D>& box, double least) {
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
    placed.resize(bodies.count());
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (std::size_t k = 0; k < bodies.count(); ++k) {
      Placed<D>& p = placed[next[cell[k]]++];
      std::copy_n(bodies.row(k), D, p.x.begin());
      p.radius = bodies.radius(k), p.body = static_cast<std::uint32_t>(k);
    }
  }

  std::array<int, D> coordinates(const double* x) const {
    std::array<int, D> at;
    for (std::size_t e = 0; e < D; ++e)
      at[e] = std::clamp(static_cast<int>((x[e] - lo[e]) * inverse[e]), 0, cells[e] - 1);
    return at;
  }
  std::uint32_t index(const std::array<int, D>& at) const {
    std::size_t n = 0;
    for (std::size_t e = D; e-- > 0;) n = n * static_cast<std::size_t>(cells[e]) + static_cast<std::size_t>(at[e]);
    return static_cast<std::uint32_t>(n);
  }
};

}  // namespace jam
