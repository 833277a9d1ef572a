// Sizes of bodies: of discs and spheres, or of clusters of spherocylinders, whose size factor scales all lengths.
#pragma once

#include <cstddef>

#include "jamscape/packing/packing.hpp"

namespace jam {

/// Of the union of its arms; of a disc (no clusters, two dimensions) its area, of a sphere its volume.
double body_volume(const Packing& packing, std::size_t grain);

/// Of the shadow along z.
double body_area(const Packing& packing, std::size_t grain);

/// L: the mean over the bodies of their shape's length, at size factor 1; of discs and spheres the mean diameter.
/// 0 without grains.
double body_length(const Packing& packing);

/// Mean over the bodies of how close a centre can come to a wall: radius of a disc, a sphere, the thinnest arm.
/// 0 without grains.
double wall_distance(const Packing& packing);

}  // namespace jam
