// The passes of clusters for vectors of four or eight. Included by one file per vector width.
#pragma once

#include "jamscape/dem/cluster_near_wide.hpp"
#include "jamscape/dem/cluster_press_wide.hpp"
#include "jamscape/dem/cluster_turn_wide.hpp"

namespace jam::HWY_NAMESPACE::clusters {

constexpr ClusterKernels kernels_named(const char* name) {
  return {name, near, collect, press, press_listed, integrate_wide};
}

}  // namespace jam::HWY_NAMESPACE::clusters
