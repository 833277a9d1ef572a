// The start of clusters in a container: drawn sizes, places on a lattice or at random, random orientations and
// velocities (S3 Methods).
#pragma once

#include <vector>

#include "jamscape/dem/cluster_engine.hpp"
#include "jamscape/protocol/container.hpp"
#include "jamscape/protocol/simulate.hpp"

namespace jam {

/// The container and how high it is filled at the start, before anybody has a place.
struct ClusterRoom {
  ClusterShape shape;
  std::vector<double> scales;  ///< size factors of the bodies
  Container container;
  double pitch = 0;   ///< of the lattice: the largest body and start.gap
  double height = 0;  ///< of the lattice, or that at which the bodies fill start.packing_fraction
};

/// Throws a usage error naming the option that asks for what cannot be.
ClusterRoom cluster_room(const SystemOptions& system, const TaskKey& key);

/// Sites of the lattice, layer by layer from the floor.
std::vector<Vec3> lattice_sites(const ClusterRoom& room, std::size_t count);

/// The lid is the last wall, at the height of the room.
ClusterSetup cluster_start(const SystemOptions& system, const TaskKey& key, const ClusterRoom& room);

}  // namespace jam
