// Where the systems of a study jam, and what their pooled distributions say: the rows of DIR/ensemble/transitions.csv
// (transition_kinds.hpp says what each is). In a container nothing jams by compression from all sides; its rows are
// those of pooled_forces.hpp, which other systems have too where they measure what these need.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "jamscape/study/done_tasks.hpp"
#include "jamscape/study/study.hpp"

namespace jam {

struct Transition {
  std::string quantity;
  std::size_t n = 0;
  double value = 0;          ///< NaN where there is none
  double se = 0;             ///< NaN where it cannot be estimated
  std::size_t left_out = 0;  ///< states that were not looked at, since a frame of them is marked (ledger.hpp)
};

/// Why it has no value.
std::string why_missing(const Transition& transition);

/// What counts as jammed beside S1's and S2's readings (options jamming_z, jamming_pressure).
struct Jamming {
  double z = 4;
  double pressure = 1e-3;
  double pressure_exponent = 1;  ///< of pressure with the distance from jamming: 1 linear contacts, 1.5 Hertz
};

/// Those of jamming. Empty where z was not measured. `seed` and `key` name the random numbers of the bootstrap.
std::vector<Transition> find_jamming(const FrameSeries& series, const Jamming& at, std::uint64_t seed,
                                     const std::string& key);

/// All of a system, whose tasks `done` holds.
std::vector<Transition> find_transitions(const Study& study, std::size_t system,
                                         const std::vector<const DoneTask*>& done,
                                         const std::vector<const Measure*>& measures, const FrameSeries& series);

/// Writes the table and returns the transitions of each system.
std::vector<std::vector<Transition>> write_transitions(const Study& study, const std::vector<DoneTask>& done,
                                                       const std::filesystem::path& results);

}  // namespace jam
