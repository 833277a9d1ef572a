// A part of something: 0 of nothing.
#pragma once

namespace jam {

inline double ratio(double over, double under) { return under > 0 ? over / under : 0; }

}  // namespace jam
