// A shape as the page draws it.
#pragma once

#include "jamscape/geometry/cluster.hpp"
#include "jamscape/report/json.hpp"

namespace jam {

/// For size factor 1: arms (each with its centre, direction, half length and radius), circumradius and length.
Json shape_json(const ClusterShape& shape);

}  // namespace jam
