// Weighted graphs for tests and benches, the same for a given seed everywhere.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "jamscape/base/random.hpp"
#include "jamscape/network/graph.hpp"

namespace jam::examples {

/// Draws the weight of one edge.
using Weights = std::function<double(Random&)>;

/// Continuous weights of mean 1, decaying like the forces of a packing.
Weights forces();
/// Whole numbers 0..levels-1 over (levels - 1): many equal weights, some of them 0.
Weights levels(int levels);

Random stream(std::uint64_t seed);

/// Links given later get weights from `weights`.
WeightedGraph graph(std::uint32_t vertices, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& links,
                    const Weights& weights, Random& random);

/// Each pair of vertices is linked with probability p.
WeightedGraph erdos_renyi(std::uint32_t vertices, double p, const Weights& weights, std::uint64_t seed);

/// Points uniform in the unit square (dimension 2) or cube (3), linked below a distance.
WeightedGraph geometric(std::uint32_t vertices, int dimension, double distance, const Weights& weights,
                        std::uint64_t seed);

enum class Lattice { square, triangular, honeycomb, cubic, fcc };

/// A lattice of about `vertices` points; each link is kept with probability `kept`.
WeightedGraph lattice(Lattice kind, std::uint32_t vertices, double kept, const Weights& weights, std::uint64_t seed);

/// The contact network of soft bidisperse (1 : 1.4) discs or spheres in a periodic box, pushed apart from random places
/// until most overlaps are small. Weights are overlaps over their mean. Steps: about 200 for a network like a
/// packing's.
WeightedGraph packing(std::uint32_t grains, int dimension, double packing_fraction, int steps, std::uint64_t seed);

/// Weights above `most` become `most`.
WeightedGraph clamped(WeightedGraph graph, double most);

/// `extra` more vertices without edges, and all vertices and edges in another order.
WeightedGraph shuffled(const WeightedGraph& graph, std::uint32_t extra, std::uint64_t seed);

/// Both graphs side by side, not linked.
WeightedGraph side_by_side(const WeightedGraph& a, const WeightedGraph& b);

}  // namespace jam::examples
