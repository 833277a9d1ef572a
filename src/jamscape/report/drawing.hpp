// A packing as something to draw: nodes with a radius (of clusters: a shape and an orientation), and lines with a force
// between them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "jamscape/observe/options.hpp"
#include "jamscape/packing/packing.hpp"

namespace jam {

struct Drawing {
  int dimension = 2;
  Vec3 lower{},
      upper{};  ///< corners of the picture: the box, and the beads of its walls; of clusters up to the highest
  /// Grains, then the beads in the picture, then points without a radius: where a force meets a plane wall, and where
  /// the line between two grains that touch across a periodic border leaves the box.
  std::size_t grains = 0, beads = 0;
  std::vector<Vec3> position;
  std::vector<double> radius;
  std::vector<std::uint32_t> ends;  ///< two nodes a line
  std::vector<double> force;        ///< per line, over the mean force between grains

  /// Clusters only: shapes, and per grain which it has, how it is turned, and its stress i = I_1/<I_1>. The radius is
  /// that of the circumscribed sphere, from which the size factor follows.
  std::vector<ClusterShape> shapes;
  std::vector<std::int32_t> shape;
  std::vector<Quaternion> orientation;
  std::vector<double> stress;

  struct Cylinder {
    int axis = 1;
    Vec3 centre{};
    double radius = 0;
  };
  std::optional<Cylinder> cylinder;

  std::size_t lines() const { return force.size(); }
};

/// A line for every contact with a positive normal force; between two clusters a single one, of the sum of their
/// contact forces. Forces are in units of the mean of the network that the options describe: without rattlers where
/// they are removed, not clamped; `force` says which force of a contact is drawn.
Drawing drawing(const Packing& packing, const MeasureOptions& options);
Drawing drawing(const Packing& packing, EdgeForce force);

}  // namespace jam
