// A packing as something to draw: nodes with a radius, and lines with a force between them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "jamscape/packing/packing.hpp"

namespace jam {

struct Drawing {
  std::array<double, 4> extent{};  ///< x and y of the lower and upper corner of the picture
  /// Grains, then the beads in the picture, then points without a radius: where a force meets a plane wall, and the
  /// periodic images of grains that touch across the border.
  std::size_t grains = 0, beads = 0;
  std::vector<double> x, y, radius;
  std::vector<std::uint32_t> ends;  ///< two nodes a line
  std::vector<double> force;        ///< per line, over the mean normal force between grains

  std::size_t lines() const { return force.size(); }
};

/// Of a packing in two dimensions: every contact with a positive normal force.
Drawing drawing(const Packing& packing);

}  // namespace jam
