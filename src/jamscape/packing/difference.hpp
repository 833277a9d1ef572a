// Two packings compared to the bit.
#pragma once

#include <string>

#include "jamscape/packing/packing.hpp"

namespace jam {

/// The first field (fields.hpp) in which two packings differ in any bit, e.g. "grains.position" or "walls.force"; empty
/// when they are the same.
std::string first_difference(const Packing& a, const Packing& b);

}  // namespace jam
