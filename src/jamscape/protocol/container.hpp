// Containers of clusters: a floor at y = 0, fixed sides, and a lid that comes down.
#pragma once

#include "jamscape/geometry/cluster.hpp"
#include "jamscape/protocol/options.hpp"

namespace jam {

/// A box (in two dimensions without thickness) or an upright cylinder about the y axis. Length unit: d.
struct Container {
  int dimension = 2;
  WallModel walls = WallModel::box;
  double width = 0;      ///< of the box, or diameter of the cylinder
  double thickness = 0;  ///< of a box in three dimensions
  double bodies = 0;     ///< volume (in two dimensions: shadow area) of all bodies, overlaps not subtracted

  /// Of the floor; in two dimensions its length.
  double base() const;
  double packing_fraction(double height) const { return bodies / (base() * height); }
};

/// Discs and spheres are for boxes that close in: throws the usage error.
[[noreturn]] void refuse_balls();

/// The shape of the grains. Throws a usage error naming the option for a shape there is not.
ClusterShape grain_shape(const SystemOptions& system);

/// For bodies of these size factors. Throws a usage error where the largest does not fit.
Container container(const SystemOptions& system, const ClusterShape& shape, const std::vector<double>& scales);

}  // namespace jam
