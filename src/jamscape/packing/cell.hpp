// The geometry of a packing's cell: edges a, b, c from a corner, upright or tilted (packing.hpp has the record).
//
// A periodic cell stands for a lattice of copies, and many cells for the same one: an edge plus a multiple of another
// periodic edge gives an equivalent cell. What is measured must not depend on the choice, so places are looked at in
// the reduced cell, whose edges are as short as they can be; where the lattice has a box for a cell, that is the box.
// Source: Minkowski reduction in two and three dimensions; Semaev, CaLC 2001, LNCS 2146, 181.
#pragma once

#include <array>

#include "jamscape/packing/packing.hpp"

namespace jam {

/// A cell of given edges; in two dimensions c is {0, 0, 0}, or along z.
Domain make_cell(const Vec3& origin, const std::array<Vec3, 3>& edges, const std::array<bool, 3>& periodic);

/// By how much a periodic copy is shifted.
inline Vec3 image_shift(const Domain& cell, const std::array<std::int8_t, 3>& image) {
  Vec3 shift{};
  for (int k = 0; k < 3; ++k) shift[k] = image[static_cast<std::size_t>(k)] * (cell.hi[k] - cell.lo[k]);
  if (!cell.upright())
    for (std::size_t k = 0; k < 3; ++k) shift += static_cast<double>(image[k]) * cell.tilt[k];
  return shift;
}

/// Area (2D) or volume (3D).
double cell_volume(const Domain& cell, int dimension);

/// An equivalent cell: periodic edges as short as possible and in the order of their axes, edges that are not periodic
/// across them. An upright cell stays what it is.
Domain reduced(const Domain& cell, int dimension);

/// The faces of a cell, and distances from them.
class Faces {
 public:
  Faces(const Domain& cell, int dimension);

  /// Between the two faces that edge k joins.
  double width(int k) const { return width_[static_cast<std::size_t>(k)]; }
  /// From the face through the origin, along its normal.
  double above_low(int k, const Vec3& x) const;
  double below_high(int k, const Vec3& x) const;
  /// Moved by whole edges into the cell, along the periodic ones.
  Vec3 wrapped(Vec3 x) const;

 private:
  Domain cell_;
  int dimension_;
  bool upright_;
  std::array<Vec3, 3> normal_{};  // of the face that edge k starts from, into the cell
  std::array<double, 3> width_{};
};

}  // namespace jam
