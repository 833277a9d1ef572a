// A packing as something to draw: nodes with a radius, and lines with a force between them.
#pragma once

#include <cstdint>
#include <vector>

#include "jamscape/observe/options.hpp"
#include "jamscape/packing/packing.hpp"

namespace jam {

struct Drawing {
  int dimension = 2;
  Vec3 lower{}, upper{};  ///< corners of the picture: the box, and the beads of its walls
  /// Grains, then the beads in the picture, then points without a radius: where a force meets a plane wall, and where
  /// the line between two grains that touch across a periodic border leaves the box.
  std::size_t grains = 0, beads = 0;
  std::vector<Vec3> position;
  std::vector<double> radius;
  std::vector<std::uint32_t> ends;  ///< two nodes a line
  std::vector<double> force;        ///< per line, over the mean force between grains

  std::size_t lines() const { return force.size(); }
};

/// Every contact with a positive normal force. `force` says which force of a contact is drawn.
Drawing drawing(const Packing& packing, EdgeForce force);

}  // namespace jam
