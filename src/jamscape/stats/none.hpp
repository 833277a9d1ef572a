// The value of what does not exist: too few numbers, no fit.
#pragma once

#include <limits>

namespace jam {

inline constexpr double none = std::numeric_limits<double>::quiet_NaN();

}  // namespace jam
