// Pairs of equal bodies about to collide at one known place, drawn at random, and what becomes of them in our engine.
#pragma once

#include <cstdint>
#include <vector>

#include "jamscape/contact/law.hpp"
#include "jamscape/dem/cluster_bodies.hpp"
#include "jamscape/geometry/cluster.hpp"

namespace jam::clusters {

enum class Place {
  sides,  ///< the cylinders of two arms, at an angle
  side,   ///< the end of an arm on the cylinder of another
  ends    ///< the ends of two arms
};

/// One law for all impacts, linear, unclipped. Masses are those of density 1, lengths in d.
struct Law {
  double k_n = 0, k_t = 0, gamma_n = 0, gamma_t = 0, mu = 0;
};

struct Impacts {
  ClusterShape shape;
  ClusterBodies bodies;  ///< 2 k and 2 k + 1 collide; pairs are far from each other
  std::size_t pairs() const { return bodies.size() / 2; }
};

/// Approach with a normal speed of .3 to .7 and a slip of 1.2 to 2.5 between the contact points, `gap` apart.
Impacts draw(const ClusterShape& shape, Place place, std::size_t pairs, double gap, std::uint64_t seed);

struct Motion {
  std::vector<Vec3> velocity, spin;  ///< of each body
};

/// After `steps` steps of our engine.
Motion collide(const Impacts& impacts, const Law& law, double dt, int steps);

/// Root mean square over the bodies of the velocities' difference and of that of the spins times L/2.
double difference(const Motion& a, const Motion& b, double half_length);

}  // namespace jam::clusters
