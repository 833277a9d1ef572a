// How the integration passes read and write bodies: one at a time, or two motions side by side in one vector of eight
// doubles (of two discs, or the two of a sphere). See Row<D> for what lies where. Included by one file per vector
// width.
#pragma once

#include <cstddef>

#include "jamscape/dem/rows.hpp"
#include "jamscape/geometry/scalar.hpp"

namespace jam {
namespace {  // each file that includes this gets its own copy, compiled for its own vector width

using Piece = double __attribute__((vector_size(32)));
using Two = double __attribute__((vector_size(64)));  // by reference only: its ABI depends on the vector width

JAM_INLINE Piece& piece(double* p) { return *reinterpret_cast<Piece*>(p); }
JAM_INLINE Two& two(double* p) { return *reinterpret_cast<Two*>(p); }

template <class V>
JAM_INLINE void keep_larger(V& largest, const V& v) {
  const V square = v * v;
  largest = largest > square ? largest : square;
}

/// The motions of one body, one after another.
template <int D>
struct OneBody {
  using Vector = Piece;
  static constexpr std::size_t bodies = 1;
  static constexpr int vectors = Row<D>::motions;

  static JAM_INLINE void load_motion(double* row, int m, Piece& x, Piece& v) {
    x = piece(row + Row<D>::position_of(m));
    v = piece(row + Row<D>::velocity_of(m));
  }
  static JAM_INLINE void store_motion(double* row, int m, const Piece& x, const Piece& v) {
    piece(row + Row<D>::position_of(m)) = x;
    piece(row + Row<D>::velocity_of(m)) = v;
  }
  static JAM_INLINE Piece& force(double* forces, int m) { return piece(forces + 4 * m); }
  /// Inverse inertias for the components of motion m.
  static JAM_INLINE void load_inverse(const double* q, int m, Piece& inverse) {
    inverse = D == 2 ? Piece{q[0], q[0], q[1], q[1]} : Piece{q[m], q[m], q[m], q[m]};
  }
  static JAM_INLINE void load_derivatives(double* d, int m, Piece& a, Piece& jerk, Piece& snap) {
    a = piece(d + 12 * m), jerk = piece(d + 12 * m + 4), snap = piece(d + 12 * m + 8);
  }
  static JAM_INLINE void store_derivatives(double* d, int m, const Piece& a, const Piece& jerk, const Piece& snap) {
    piece(d + 12 * m) = a, piece(d + 12 * m + 4) = jerk, piece(d + 12 * m + 8) = snap;
  }
  static JAM_INLINE void keep_fastest(Piece& fastest, int m, const Piece& v) {
    if (m == 0) keep_larger(fastest, v);
  }
};

/// Two motions at once: in two dimensions of two bodies.
template <int D>
struct TwoMotions {
  using Vector = Two;
  static constexpr std::size_t bodies = D == 2 ? 2 : 1;
  static constexpr int vectors = 1;

  static JAM_INLINE void load_motion(double* row, int, Two& x, Two& v) {
    const Two p = two(row), q = two(row + 8);
    if constexpr (D == 2) {
      x = __builtin_shufflevector(p, q, 0, 1, 2, 3, 8, 9, 10, 11);
      v = __builtin_shufflevector(p, q, 4, 5, 6, 7, 12, 13, 14, 15);
    } else {
      x = __builtin_shufflevector(p, q, 0, 1, 2, 3, 12, 13, 14, 15);
      v = __builtin_shufflevector(p, q, 4, 5, 6, 7, 8, 9, 10, 11);
    }
  }
  static JAM_INLINE void store_motion(double* row, int, const Two& x, const Two& v) {
    two(row) = __builtin_shufflevector(x, v, 0, 1, 2, 3, 8, 9, 10, 11);
    if constexpr (D == 2)
      two(row + 8) = __builtin_shufflevector(x, v, 4, 5, 6, 7, 12, 13, 14, 15);
    else
      two(row + 8) = __builtin_shufflevector(v, x, 4, 5, 6, 7, 12, 13, 14, 15);
  }
  static JAM_INLINE Two& force(double* forces, int) { return two(forces); }
  static JAM_INLINE void load_inverse(const double* q, int, Two& inverse) {
    if constexpr (D == 2) {
      const Piece p = *reinterpret_cast<const Piece*>(q);
      inverse = __builtin_shufflevector(p, p, 0, 0, 1, 1, 2, 2, 3, 3);
    } else {
      inverse = Two{q[0], q[0], q[0], q[0], q[1], q[1], q[1], q[1]};
    }
  }
  static JAM_INLINE void load_derivatives(double* d, int, Two& a, Two& jerk, Two& snap) {
    const Two p = two(d), q = two(d + 8), r = two(d + 16);  // a jerk | snap a | jerk snap
    a = __builtin_shufflevector(p, q, 0, 1, 2, 3, 12, 13, 14, 15);
    jerk = __builtin_shufflevector(p, r, 4, 5, 6, 7, 8, 9, 10, 11);
    snap = __builtin_shufflevector(q, r, 0, 1, 2, 3, 12, 13, 14, 15);
  }
  static JAM_INLINE void store_derivatives(double* d, int, const Two& a, const Two& jerk, const Two& snap) {
    two(d) = __builtin_shufflevector(a, jerk, 0, 1, 2, 3, 8, 9, 10, 11);
    two(d + 8) = __builtin_shufflevector(snap, a, 0, 1, 2, 3, 12, 13, 14, 15);
    two(d + 16) = __builtin_shufflevector(jerk, snap, 4, 5, 6, 7, 12, 13, 14, 15);
  }
  static JAM_INLINE void keep_fastest(Two& fastest, int, const Two& v) { keep_larger(fastest, v); }
};

}  // namespace
}  // namespace jam
