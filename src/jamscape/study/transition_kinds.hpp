// The rows of DIR/ensemble/transitions.csv: numbers that belong to a system as a whole, made of all its realisations.
//
//   system, <options that differ between systems>, quantity, n, value, se
#pragma once

#include <span>
#include <string_view>

namespace jam {

struct TransitionKind {
  std::string_view name;
  std::string_view text;  ///< what it is, and what its error comes from
  std::string_view source;
  std::string_view missing;       ///< what it means that there is none
  bool packing_fraction = false;  ///< a state may be named by it: "rho_j+0.02"
};

/// In the order of the table.
std::span<const TransitionKind> transition_kinds();

/// Why a transition without a value has none: "no fit: ..." is not "not reached".
std::string_view why_missing(std::string_view quantity);

}  // namespace jam
