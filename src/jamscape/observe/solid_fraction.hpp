// How densely a packing pressed by a lid fills its space, and what the lid carries:
//
//   solid_fraction  = sum of the bodies' volumes / volume of the space; in two dimensions of clusters the space is as
//   thick
//                     as an arm (S3: T = d_p), of discs areas over the area
//   weight_over_load = weight of the bodies / force on the lid, the weight being the force of the bodies on all walls
//                     down the lid's normal, which is theirs while they rest, whatever friction the sides have
//
// The lid is the wall of that role (packing/wall_roles.hpp). Source: S3 Data analysis; theory sec. 4 and 5 ("S3 500
// N").
#pragma once

#include "jamscape/observe/measure.hpp"

namespace jam {

double solid_fraction(const Packing& packing);

/// NaN without a lid, or where it carries nothing.
double weight_over_load(const Packing& packing);

Measure solid_fraction_measure();

}  // namespace jam
