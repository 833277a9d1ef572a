// Bodies at random places: random sequential addition of rigid clusters between the walls of a container.
#pragma once

#include "jamscape/base/random.hpp"
#include "jamscape/protocol/cluster_start.hpp"

namespace jam {

/// Uniform over all rotations; in two dimensions over those about z. Source: Marsaglia, Ann. Math. Stat. 43, 645
/// (1972).
Quaternion random_orientation(Random& random, int dimension);

/// Fills positions and orientations of `bodies`, whose scales are given; the largest bodies come first, and none
/// touches another or a wall of the room. Throws a usage error where one finds no place.
void place_at_random(const ClusterRoom& room, Random& random, ClusterBodies& bodies);

}  // namespace jam
