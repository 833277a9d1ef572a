// The passes a step is made of, each for several vector widths behind one table of functions.
//
//   pairs      reads rows, indices, reduced masses; reads and writes springs, force rows, the tally
//   watch      finds those near pairs that may touch before long; until it is called again, `pairs` tests no others
//   near       finds the bodies near a body, for the list of pairs
//   integrate  reads force rows and inverse inertias; reads and writes rows (and Gear's higher derivatives); clears
//   forces
//
// Order of sums: the forces of pair k are added to body i, then to body j, for k = 0, 1, 2, ...; energies are summed in
// eight slots: k mod 8, or in a sparse range the number of touching pairs before k, mod 8. Every implementation keeps
// that order and uses correctly rounded element-wise operations only, so all of them give the same bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "jamscape/contact/law.hpp"
#include "jamscape/dem/near_bodies.hpp"
#include "jamscape/dem/rows.hpp"

namespace jam {

/// Whether products that the contact loop adds up are rounded once, with the sum (geometry/vec.hpp). For spheres, whose
/// law is long: it saves a sixth of the arithmetic.
template <int D>
inline constexpr bool fused = D == 3;

/// Sums over the pairs of one step, in slots.
struct alignas(64) Tally {
  double damped[block];   ///< power of the dashpots
  double rubbed[block];   ///< energy cut from tangential springs
  double virial[block];   ///< sum of F_n r over pairs: its rate of change under isotropic strain is the work
  double deepest[block];  ///< largest overlap
};

/// A run of pairs that share one law. `begin` and `end` are whole blocks. In a sparse range few pairs are expected to
/// touch: wide kernels look only at those of them that are watched, and collect the ones that touch before they compute
/// forces. The plain kernel tests every pair.
struct PairRange {
  std::size_t begin, end;
  bool sparse;
  std::size_t watched;  ///< sparse: how many pairs are watched, in whole blocks
  PairLaw<> law;
  NormalLaw kind;
  bool friction;
};

/// The watched pairs of a sparse range, from its `begin` on.
struct WatchArrays {
  std::uint32_t *i, *j, *shift;
  std::uint32_t* pair;     ///< which pair of the range's list
  std::uint8_t* touching;  ///< by block: the pairs that touched at the last step or still hold a spring
};

struct PairArrays {
  const double* rows;
  double* forces;
  const std::uint32_t* i;
  const std::uint32_t* j;
  const double* mbar;
  double* springs;             ///< 2D: one a pair; 3D: blocks of 8 x, 8 y, 8 z
  const std::uint32_t* shift;  ///< row of `shifts` to add to the position of j; nullptr: none
  const double* shifts;        ///< rows of four doubles
  double dt;
  double shrinking;  ///< rate of the box, -dL/dt / L: bodies come closer by as much of their distance
  Tally* tally;
  WatchArrays watch;
  std::uint32_t nobody;  ///< a body out of reach of the next one: they fill up blocks
};

struct BodyArrays {
  double* rows;
  double* forces;
  const double* inverse;  ///< 1/m and 1/I of each body
  double* derivatives;    ///< Gear: acceleration, jerk, snap, a piece of four doubles each, per motion
  std::uint8_t* calm;     ///< Gear: 1 for bodies whose derivatives are all +0, as far as the passes before know
  std::size_t count;
  double dt;
  bool few_pushed;    ///< the passes may look for bodies that nothing pushes, and leave out what that does not change
  double fastest[4];  ///< out: largest squares of the velocity components; the fourth is 0
};

/// One implementation, named by its vector width.
struct Kernels {
  const char* name;
  void (*pairs2)(const PairArrays&, const PairRange&);
  void (*pairs3)(const PairArrays&, const PairRange&);
  /// Watches the pairs of a sparse range closer than reach + margin, and those that hold springs. Returns `watched`.
  std::size_t (*watch2)(const PairArrays&, const PairRange&, double margin);
  std::size_t (*watch3)(const PairArrays&, const PairRange&, double margin);
  /// Finds the candidates after a body in memory that are nearer than the sum of radii + skin, in their order. Returns
  /// how many.
  std::size_t (*near2)(const NearQuery&, const NearBodies&);
  std::size_t (*near3)(const NearQuery&, const NearBodies&);
  void (*verlet2)(BodyArrays&);
  void (*verlet3)(BodyArrays&);
  void (*gear2)(BodyArrays&);
  void (*gear3)(BodyArrays&);

  template <int D>
  auto pairs() const {
    return D == 2 ? pairs2 : pairs3;
  }
  template <int D>
  auto watch() const {
    return D == 2 ? watch2 : watch3;
  }
  template <int D>
  auto near() const {
    return D == 2 ? near2 : near3;
  }
  template <int D>
  auto verlet() const {
    return D == 2 ? verlet2 : verlet3;
  }
  template <int D>
  auto gear() const {
    return D == 2 ? gear2 : gear3;
  }
};

/// The readable one: a loop over pairs and one over bodies. Oracle of the others.
const Kernels& plain_kernels();
/// All that this processor runs, narrowest first.
std::span<const Kernels* const> available_kernels();
/// Those in use (kernel_choice.hpp).
const Kernels& best_kernels();

}  // namespace jam
