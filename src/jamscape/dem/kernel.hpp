// The two passes a step is made of, each for several vector widths behind one table of functions.
//
//   pairs      reads rows, indices, reduced masses; reads and writes springs, force rows, the tally
//   integrate  reads force rows and inverse inertias; reads and writes rows (and Gear's higher derivatives); clears
//   forces
//
// Order of sums: the forces of pair k are added to body i, then to body j, for k = 0, 1, 2, ...; energies are summed in
// eight slots: k mod 8, or in a sparse range the number of touching pairs before k, mod 8. Every implementation keeps
// that order and uses exact element-wise operations only, so all of them give the same bits.
#pragma once

#include <cstddef>
#include <cstdint>

#include "jamscape/contact/law.hpp"
#include "jamscape/dem/rows.hpp"

namespace jam {

/// Sums over the pairs of one step, in slots.
struct alignas(64) Tally {
  double damped[block];   ///< power of the dashpots
  double rubbed[block];   ///< energy cut from tangential springs
  double virial[block];   ///< sum of F_n r over pairs: its rate of change under isotropic strain is the work
  double deepest[block];  ///< largest overlap
};

/// A run of pairs that share one law. `begin` and `end` are whole blocks. In a sparse range few pairs are expected to
/// touch: wide kernels collect those that do before they compute forces.
struct PairRange {
  std::size_t begin, end;
  bool sparse;
  PairLaw<> law;
  NormalLaw kind;
  bool friction;
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
  Tally* tally;
};

struct BodyArrays {
  double* rows;
  double* forces;
  const double* inverse;  ///< inverse inertias, rows like forces
  double* derivatives;    ///< Gear: acceleration, jerk, snap, a piece of four doubles each, per motion
  std::size_t count;
  double dt;
  double fastest[4];  ///< out: largest squares of the velocity components; the fourth is 0
};

/// One implementation, named by its vector width.
struct Kernels {
  const char* name;
  void (*pairs2)(const PairArrays&, const PairRange&);
  void (*pairs3)(const PairArrays&, const PairRange&);
  void (*verlet2)(BodyArrays&);
  void (*verlet3)(BodyArrays&);
  void (*gear2)(BodyArrays&);
  void (*gear3)(BodyArrays&);

  template <int D>
  auto pairs() const {
    return D == 2 ? pairs2 : pairs3;
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
struct KernelList {
  const Kernels* entry[3];
  int count;
};
KernelList available_kernels();
/// The widest this processor runs; JAMSCAPE_KERNELS=plain|avx2|avx512 in the environment picks another.
const Kernels& best_kernels();

}  // namespace jam
