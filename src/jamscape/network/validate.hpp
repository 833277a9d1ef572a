// The rules of a WeightedGraph, checked.
#pragma once

#include "jamscape/network/graph.hpp"

namespace jam {

/// Throws a data error that names the first edge with: an end out of range, both ends the same, a weight that is
/// negative, infinite or not a number, or the ends of an earlier edge. Also when the three arrays differ in length or
/// there are 2^31 or more vertices or edges.
void validate(const WeightedGraph& graph);

/// The part of validate() that needs no memory: everything except repeated edges.
void validate_edges(const WeightedGraph& graph);

}  // namespace jam
