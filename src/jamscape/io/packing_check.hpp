// Packings made elsewhere: what contradicts itself is refused, what a file states outright is believed, and what was
// assumed is said. Every reader ends here, whatever the file.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "jamscape/packing/packing.hpp"

namespace jam {

/// Where the parts of a packing stand in the files they come from, for errors.
struct PackingPlaces {
  std::function<std::string(std::size_t grain)> grain;
  std::function<std::string(std::size_t contact)> contact;
  std::string box;
};

/// What the files state of every contact; the rest a reader has worked out.
struct StatedContacts {
  bool overlap = false, normal = false, point = false;
  bool force_vector = false;  ///< the normal force is the part of a vector along the normal
  bool tangential = false;    ///< tangential forces as vectors
};

/// Sizes and masses above 0, a box that has room, centres inside it where it is not periodic. Throws a data error.
void check_grains(const Packing& packing, const PackingPlaces& places);

/// Contacts of `packing`, which are in their final order:
///   - a listed contact of non-zero force, or with a gap within rounding, touches: an overlap that was worked out and
///   is
///     below 0 becomes 0; listed pairs of no force that are apart stay apart; both are noted;
///   - refused are centres further apart than one and a half times the two radii, normals that point away from the
///   other
///     grain or into the box's wall, points far from the grain, pairs that touch through both sides of a periodic box,
///     forces all of the wrong sign, and overlaps that are all below 0;
///   - noted are normals off the line of centres and tangential forces off the tangent plane.
/// Points are moved by whole boxes to the first grain, and grains far outside a periodic box into it, with their
/// images.
void check_contacts(Packing& packing, const StatedContacts& stated, const PackingPlaces& places,
                    std::vector<std::string>& notes);

}  // namespace jam
