// Where a system jams, by every reading of "Z reaches 3" that theory sec. 6a lists. DIR/ensemble/transitions.csv:
//
//   system, <options that differ between systems>, quantity, n, value, se
//
//   rho_c           last upward crossing of the ensemble-mean z at 3, linear interpolation; error by jackknife (S1
//                   Table I)
//   rho_c_walls     the same with z_walls: wall contacts counted too
//   rho_c_multi     the same with z_multi: over grains with two contacts or more
//   rho_c_plain     rho_c on the axis of packing_fraction_plain
//   rho_inflection  inflection of the mean z: logistic plus line around rho_c; error by bootstrap
//   rho_c_single    mean over the realisations of their own crossings
//
// and where frames follow relaxations (S2 Sec. 4; only those frames count then, for all rows)
//
//   rho_j           inflection of the whole mean z, with different slopes below and above (stats/inflection.hpp)
//   z_at_rho_j      the fitted z there, half way up the jump; error by bootstrap
//   z_above         mean z at the first state above rho_j
//   rho_j_backbone, z_backbone_at_rho_j, z_backbone_above   the same for z_backbone (rattlers removed)
//   rho_p           packing fraction of the first state from which on a realisation percolates, mean over realisations
//
// In a container nothing jams by compression from all sides; its rows are those of pooled_forces.hpp, which other
// systems have too where they measure what these need.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "jamscape/study/done_tasks.hpp"
#include "jamscape/study/study.hpp"

namespace jam {

/// Those that are packing fractions.
inline constexpr std::array<std::string_view, 9> packing_fraction_transitions = {
    "rho_c",        "rho_c_walls", "rho_c_multi",    "rho_c_plain", "rho_inflection",
    "rho_c_single", "rho_j",       "rho_j_backbone", "rho_p"};

struct Transition {
  std::string quantity;
  std::size_t n = 0;
  double value = 0;  ///< NaN where there is none
  double se = 0;     ///< NaN where it cannot be estimated
};

/// Those of jamming. Empty where z was not measured. `seed` and `key` name the random numbers of the bootstrap.
std::vector<Transition> find_jamming(const FrameSeries& series, std::uint64_t seed, const std::string& key);

/// All of a system, whose tasks `done` holds.
std::vector<Transition> find_transitions(const Study& study, std::size_t system,
                                         const std::vector<const DoneTask*>& done,
                                         const std::vector<const Measure*>& measures, const FrameSeries& series);

/// Writes the table and returns the transitions of each system.
std::vector<std::vector<Transition>> write_transitions(const Study& study, const std::vector<DoneTask>& done,
                                                       const std::filesystem::path& results);

}  // namespace jam
