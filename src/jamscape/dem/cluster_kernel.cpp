#include "jamscape/dem/cluster_kernel.hpp"

#include "jamscape/dem/kernel_choice.hpp"

namespace jam {

#ifdef JAM_X86
const ClusterKernels& avx2_cluster_kernels();
const ClusterKernels& avx512_cluster_kernels();
#endif

std::span<const ClusterKernels* const> available_cluster_kernels() {
#ifdef JAM_X86
  static const ClusterKernels* const all[] = {&plain_cluster_kernels(), &avx2_cluster_kernels(),
                                              &avx512_cluster_kernels()};
#else
  static const ClusterKernels* const all[] = {&plain_cluster_kernels()};
#endif
  return {all, widths_available()};
}

const ClusterKernels& best_cluster_kernels() { return *available_cluster_kernels()[width_in_use()]; }

void ArmContacts::resize(std::size_t pairs) {
  count = 0;
  pair.resize(pairs + block);
  touching.assign(pairs / block, 0);
}

CollectArrays collect_arrays(const ClusterState& b, const ArmPairs& p, ArmContacts& out) {
  return {b.arms.data(), p.arm_i.data(), p.arm_j.data(), p.size(), out.pair.data(), out.touching.data()};
}

PressArrays press_arrays(ClusterState& b, ArmPairs& p, ArmContacts& c, const PressRule& rule, ClusterTally& tally) {
  return {.rows = b.rows.data(),
          .arms = b.arms.data(),
          .forces = b.forces.data(),
          .i = p.i.data(),
          .j = p.j.data(),
          .arm_i = p.arm_i.data(),
          .arm_j = p.arm_j.data(),
          .mbar = p.mbar.data(),
          .springs = p.springs.data(),
          .pairs = p.size(),
          .pair = c.pair.data(),
          .touching = c.touching.data(),
          .contacts = c.count,
          .rule = &rule,
          .tally = &tally};
}

MotionArrays motion_arrays(ClusterState& b, double dt, const Vec3& gravity) {
  return {.rows = b.rows.data(),
          .arms = b.arms.data(),
          .forces = b.forces.data(),
          .momentum = b.momentum.data(),
          .moved = b.moved.data(),
          .inverse = b.inverse.data(),
          .own_arms = b.own_arms.data(),
          .scale = b.scale.data(),
          .skin = b.skin.data(),
          .top = b.top.data(),
          .first_arm = b.first_arm.data(),
          .first_own = b.first_own.data(),
          .count = b.count(),
          .dt = dt,
          .gravity = {gravity[0], gravity[1], gravity[2], 0},
          .centred = b.centred,
          .outrun = false};
}

}  // namespace jam
