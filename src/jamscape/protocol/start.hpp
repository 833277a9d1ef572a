// The start of a simulation: grains drawn from their size distribution, set on a lattice with random velocities, walls
// around them.
#pragma once

#include <vector>

#include "jamscape/dem/engine.hpp"
#include "jamscape/protocol/box.hpp"
#include "jamscape/protocol/options.hpp"
#include "jamscape/protocol/simulate.hpp"

namespace jam {

/// Diameters of all grains, mean 1 over the distribution (not over the sample). The same key gives the same sizes.
std::vector<double> draw_diameters(const GrainOptions& options, const TaskKey& key);

/// Mean of d^power over the size distribution: masses are d^D / <d^D>, so that their mean is 1.
double mean_power(const GrainOptions& options, int power);

struct StartBox {
  BoxMeasure measure;
  std::int64_t per_side = 0;  ///< lattice sites along an edge
  double length = 0;          ///< of the box at the start
  double spacing = 0, margin = 0;
};

/// The smallest box that holds the lattice at or below start.packing_fraction.
StartBox start_box(const SystemOptions& system, const std::vector<double>& diameters);

/// Throws a usage error naming the option that asks for what cannot be: bead walls in three dimensions, clusters in a
/// box that shrinks, a restitution that the damping rule cannot reach. start() throws the same.
void check_start(const SystemOptions& system);

template <int D>
EngineSetup<D> start(const SystemOptions& system, const TaskKey& key);

}  // namespace jam
