// What the frames of a simulation go by in tables and means over realisations.
#pragma once

#include <string_view>

namespace jam {

struct StateAxis {
  std::string_view name;  ///< column
  bool planned;           ///< every frame has its value before the simulation; otherwise it is what comes out
};

inline constexpr StateAxis planned_packing_fraction = {"packing_fraction_target", true};
inline constexpr StateAxis reached_packing_fraction = {"packing_fraction_target", false};

}  // namespace jam
