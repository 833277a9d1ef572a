// Thresholds at which level sets are taken.
#pragma once

#include <vector>

namespace jam {

/// 0, step, 2 step, ... up to max (included when it is a multiple of step).
std::vector<double> threshold_grid(double max, double step);

}  // namespace jam
