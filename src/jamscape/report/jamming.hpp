// The packing fraction at which a system jams, as the report marks it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jamscape/report/results.hpp"

namespace jam {

struct JammingPoint {
  double value;
  std::string quantity;  ///< of ensemble/transitions.csv
};

/// Per system: the inflection rho_j where the study has it (S2); else rho_c, where the mean Z crosses 3, for discs
/// (S1); else the inflection of Z. Nothing where there is none.
std::vector<std::optional<JammingPoint>> jamming_points(const Results& results);

}  // namespace jam
