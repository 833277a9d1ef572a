// The list of arm pairs that may touch before it is made anew, with their tangential springs.
//
// Pairs stand in the order in which their forces are summed: by body (spatial order), partner, arm of the one, arm of
// the other. The arm of the body with the smaller id is always the first, so that a contact looks the same whatever the
// order in memory. The list is padded to whole blocks with pairs that never touch.
#pragma once

#include <cstdint>
#include <vector>

#include "jamscape/dem/cluster_bodies.hpp"

namespace jam {

struct ClusterKernels;

struct ArmPairs {
  std::size_t count = 0;                      ///< without padding
  Aligned<std::uint32_t> i, j, arm_i, arm_j;  ///< bodies and arms
  Aligned<double> mbar;                       ///< reduced mass
  Aligned<double> springs;                    ///< rows of four: x y z 0
  Aligned<std::uint8_t> held;                 ///< a bit a pair: touched at the last step, so that its spring is kept

  std::size_t size() const { return i.size(); }
  bool holds(std::size_t k) const { return held[k / block] >> (k % block) & 1; }
  Vec3 spring(std::size_t k) const { return vec3(springs.data() + 4 * k); }
};

/// Springs by two numbers, to be found again when a list is made anew.
class SpringsByNumber {
 public:
  explicit SpringsByNumber(std::size_t firsts) : start_(firsts + 1, 0) {}
  /// All are put before any is looked for.
  void put(std::uint32_t first, std::uint32_t second, const Vec3& spring);
  void sort();
  /// nullptr where none was put.
  const Vec3* find(std::uint32_t first, std::uint32_t second) const;

 private:
  struct Entry {
    std::uint32_t first, second;
    Vec3 spring;
  };
  std::vector<Entry> put_, sorted_;
  std::vector<std::uint32_t> start_;
};

/// All pairs of arms of different bodies closer than the sum of radii and the bodies' skins. Springs are taken over
/// from `old`, made of the same bodies, which may have been reordered since: `old_arm_id` is arm_id of that time.
ArmPairs list_arm_pairs(const ClusterState& bodies, const ArmPairs& old, const std::vector<std::uint32_t>& old_arm_id,
                        const ClusterKernels& kernels);

}  // namespace jam
