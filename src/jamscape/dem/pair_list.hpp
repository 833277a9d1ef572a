// The list of pairs that may touch before it is made anew, with their tangential springs.
//
// Pairs stand in the order in which their forces are summed. Three runs: grain-grain, grain-grain across a periodic
// face, grain-bead; each padded to whole blocks. Within a run, grains go by tiles of 64; in a tile the touching pairs
// come first, then the near ones, and each of the two takes one partner of every grain in turn: neighbours in the list
// then never wait for each other's force sums, and blocks of near pairs are left after their distances.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "jamscape/dem/bodies.hpp"
#include "jamscape/dem/rows.hpp"
#include "jamscape/geometry/vec.hpp"

namespace jam {

enum class PairKind { inner, across, bead };
inline constexpr int pair_kinds = 3;

/// The box of a periodic simulation; lengths 0 where it is not periodic.
template <int D>
struct Periodic {
  std::array<double, D> lo{}, length{};
};

template <int D>
struct PairList {
  static constexpr std::size_t spring_size = D == 2 ? 1 : 3;

  std::array<std::size_t, pair_kinds + 1> start{};  ///< runs: kind k is start[k] .. start[k + 1]
  Aligned<std::uint32_t> i, j;                      ///< i < j
  Aligned<std::uint32_t> shift;                     ///< kind `across`: which periodic image of j, a row of shifts()
  Aligned<double> mbar;                             ///< reduced mass
  Aligned<double> springs;                          ///< 2D: by pair; 3D: in blocks of 8 x, 8 y, 8 z

  std::size_t size() const { return i.size(); }
  double* spring(std::size_t k) { return springs.data() + (D == 2 ? k : k / block * 3 * block + k % block); }
  const double* spring(std::size_t k) const {
    return springs.data() + (D == 2 ? k : k / block * 3 * block + k % block);
  }
};

/// Rows of four doubles, one for each of the 3^D neighbouring images of the box; number (3^D - 1)/2 is no shift.
template <int D>
Aligned<double> image_shifts(const Periodic<D>& box);

/// The image numbers (-1, 0, 1 in each direction) of a row of image_shifts().
template <int D>
std::array<std::int8_t, 3> image_of(std::uint32_t shift);

/// All pairs closer than the sum of radii + skin, springs taken over from `old` (made of the same bodies, whose grains
/// may have been reordered since: `old_id` is their id array of that time). Reduced mass: m_i m_j / (m_i + m_j), and
/// m_i against a bead. Bodies must lie inside the box in periodic directions. Throws a usage error when a periodic box
/// is less than three cells wide.
template <int D>
PairList<D> list_pairs(const Bodies<D>& bodies, const Periodic<D>& box, double skin, const PairList<D>& old,
                       const std::vector<std::uint32_t>& old_id);

/// The grains in spatial order (Morton order of cells of about a diameter): order[k] = present index of the k-th.
template <int D>
std::vector<std::uint32_t> spatial_order(const Bodies<D>& bodies);

}  // namespace jam
