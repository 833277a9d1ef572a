// The list of pairs that may touch before it is made anew, with their tangential springs.
//
// Pairs stand in the order in which their forces are summed. Three kinds: grain-grain, grain-grain across a periodic
// face, grain-bead; each kind has a run of pairs that touched when the list was made and a run of those that were near,
// padded to whole blocks. Within a run, grains go by tiles (see Parts); a tile takes one partner of every grain in
// turn: neighbours in the list then do not wait for each other's force sums.
//
// A packing cut into parts has such runs for every two parts whose bodies are near each other, then for every stretch
// of a part (see Parts); one that is not has those of its one stretch.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "jamscape/base/thread_team.hpp"
#include "jamscape/dem/bodies.hpp"
#include "jamscape/dem/kernel.hpp"
#include "jamscape/dem/parts.hpp"
#include "jamscape/dem/periodic.hpp"
#include "jamscape/dem/rows.hpp"
#include "jamscape/geometry/vec.hpp"

namespace jam {

enum class PairKind { inner, across, bead };
inline constexpr std::size_t pair_kinds = 3, pair_runs = 2 * pair_kinds;

/// The pairs of the parts a < b, or of a stretch of part a = b with the rest of its part.
struct PairGroup {
  std::uint32_t a = 0, b = 0;
  /// run 2 k: pairs of kind k that touched, run 2 k + 1: the near ones; run r is start[r] .. start[r + 1]
  std::array<std::size_t, pair_runs + 1> start{};
};

template <int D>
struct PairList {
  static constexpr std::size_t spring_size = D == 2 ? 1 : 3;

  std::vector<PairGroup> groups;  ///< each begins where the one before ends
  /// groups first_of_round[r] .. first_of_round[r + 1] share no part; forces are summed round after round. From the
  /// last one on, groups are those of the stretches, in their order.
  std::vector<std::size_t> first_of_round{0};
  Aligned<std::uint32_t> i, j;   ///< i < j
  Aligned<std::uint32_t> shift;  ///< kind `across`: which periodic image of j, a row of image_shifts()
  Aligned<double> mbar;          ///< reduced mass
  Aligned<double> springs;       ///< 2D: by pair; 3D: in blocks of 8 x, 8 y, 8 z

  std::size_t size() const { return i.size(); }
  /// Pairs that touched when the list was made, in whole blocks.
  std::size_t touching() const {
    std::size_t n = 0;
    for (const PairGroup& g : groups)
      for (std::size_t run = 0; run < pair_runs; run += 2) n += g.start[run + 1] - g.start[run];
    return n;
  }
  double* spring(std::size_t k) { return springs.data() + (D == 2 ? k : k / block * 3 * block + k % block); }
  const double* spring(std::size_t k) const {
    return springs.data() + (D == 2 ? k : k / block * 3 * block + k % block);
  }
};

/// All pairs closer than the sum of radii + skin, springs taken over from `old` (made of the same bodies, whose grains
/// may have been reordered since: `old_id` is their id array of that time). Reduced mass: m_i m_j / (m_i + m_j), and
/// m_i against a bead. Bodies must lie inside the box in periodic directions. Throws a usage error when a periodic box
/// is less than three cells wide.
template <int D>
PairList<D> list_pairs(const Bodies<D>& bodies, const Periodic<D>& box, double skin, const PairList<D>& old,
                       const std::vector<std::uint32_t>& old_id, const Parts& parts, const Kernels& kernels,
                       ThreadTeam& team);

/// The grains in spatial order (Morton order of cells of about a diameter): order[k] = present index of the k-th.
template <int D>
std::vector<std::uint32_t> spatial_order(const Bodies<D>& bodies);

}  // namespace jam
