// The passes that a step of clusters is made of, each for several vector widths behind one table of functions.
//
//   near          finds pairs of arms that may touch before long, for the list
//   collect       reads arms and pairs; writes which pairs touch
//   press         reads arms, rows, pairs and what was collected; reads and writes springs, forces, the tally
//   press_listed  both in one, over all listed pairs: faster where most of them touch
//   integrate     reads forces, inverse inertias, own arms; adds weights; reads and writes rows and momenta; writes
//   arms;
//                 clears forces
//
// Order of sums: the forces of the c-th touching pair are added to its first body, then to its second, for c = 0, 1, 2,
// ...; energies are summed in eight slots, c mod 8. Every implementation keeps that order and uses exact element-wise
// operations only, so all of them give the same bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "jamscape/contact/law.hpp"
#include "jamscape/dem/cluster_list.hpp"
#include "jamscape/dem/cluster_rules.hpp"

namespace jam {

/// The arm pairs that touch, in the order of the list.
struct ArmContacts {
  std::size_t count = 0;
  Aligned<std::uint32_t> pair;     ///< index into the list
  Aligned<std::uint8_t> touching;  ///< a bit a listed pair

  void resize(std::size_t pairs);  ///< room for all listed pairs
};

/// Sums over the contacts of one step.
struct alignas(64) ClusterTally {
  double damped[block];  ///< power of the dashpots
  double rubbed[block];  ///< energy taken by friction
  double excess[block];  ///< largest overlap - smaller radius: above 0 the axes are about to cross
};

struct PressRule {
  PairLaw<> law;
  NormalLaw kind;
  ParallelRule parallel;
  double parallel_sine2;  ///< of the angle below which arms count as parallel
  double dt;
};

/// Calls f.operator()<law, friction, parallel>() for a rule known at run time only.
template <class F>
JAM_INLINE void with_rule(const PressRule& rule, F&& f) {
  const bool middle = rule.parallel == ParallelRule::middle;
  with_law(rule.kind, [&]<NormalLaw law>() {
    if (rule.law.mu > 0)
      middle ? f.template operator()<law, true, ParallelRule::middle>()
             : f.template operator()<law, true, ParallelRule::blend>();
    else
      middle ? f.template operator()<law, false, ParallelRule::middle>()
             : f.template operator()<law, false, ParallelRule::blend>();
  });
}

// Bare arrays (see ClusterState, ArmPairs, ArmContacts): code built for a wider vector must not lend its copies of
// library functions to the rest of the program.

/// Pairs of arms to be tested for the list.
struct NearArms {
  const double* arms;
  const std::uint32_t *arm_i, *arm_j;  ///< candidates
  const double* skin;                  ///< of both, a candidate
  std::size_t count;                   ///< whole blocks
  std::uint32_t* near;                 ///< out: candidates nearer than radii + skin; with room for a block more
};

struct CollectArrays {
  const double* arms;
  const std::uint32_t *arm_i, *arm_j;
  std::size_t pairs;    ///< whole blocks
  std::uint32_t* pair;  ///< out, with room for a block more
  std::uint8_t* touching;
};

struct PressArrays {
  const double *rows, *arms;
  double* forces;
  const std::uint32_t *i, *j, *arm_i, *arm_j;
  const double* mbar;
  double* springs;
  std::size_t pairs;
  std::uint32_t* pair;
  std::uint8_t* touching;
  std::size_t contacts;
  const PressRule* rule;
  ClusterTally* tally;
};

struct MotionArrays {
  double *rows, *arms, *forces, *momentum, *moved;
  const double *inverse, *own_arms, *scale, *skin;
  const std::uint8_t* top;
  const std::uint32_t *first_arm, *first_own;
  std::size_t count;
  double dt;
  alignas(32) double gravity[4];  ///< acceleration, and 0
  bool centred;
  bool outrun;  ///< out: a body has moved farther than its skin
};

CollectArrays collect_arrays(const ClusterState& bodies, const ArmPairs& pairs, ArmContacts& out);
PressArrays press_arrays(ClusterState& bodies, ArmPairs& pairs, ArmContacts& contacts, const PressRule& rule,
                         ClusterTally& tally);
MotionArrays motion_arrays(ClusterState& bodies, double dt, const Vec3& gravity);

/// One implementation, named by its vector width.
struct ClusterKernels {
  const char* name;
  std::size_t (*near)(const NearArms&);          ///< how many are near
  std::size_t (*collect)(const CollectArrays&);  ///< how many touch
  void (*press)(const PressArrays&);
  std::size_t (*press_listed)(const PressArrays&);  ///< how many touch; `pair` is left undefined
  void (*integrate)(MotionArrays&);
};

/// The readable one: loops over pairs, contacts, bodies. Oracle of the others.
const ClusterKernels& plain_cluster_kernels();
/// All that this processor runs, narrowest first.
std::span<const ClusterKernels* const> available_cluster_kernels();
/// Those in use (kernel_choice.hpp).
const ClusterKernels& best_cluster_kernels();

}  // namespace jam
