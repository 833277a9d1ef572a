// What S3 reads off distributions, from the histograms of all realisations of a system added up, at its last state: the
// rows tail_k_pooled to rdf_peak3_pooled of transition_kinds.hpp, where the measures they need were taken. Source: S3
// Eq. 2, Table 2; theory sec. 4.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "jamscape/study/done_tasks.hpp"
#include "jamscape/study/transitions.hpp"

namespace jam {

/// Empty where P(f) and G(r) were not measured. `seed` and `key` name the random numbers of the bootstrap.
std::vector<Transition> pooled_forces(const std::vector<const DoneTask*>& done,
                                      const std::vector<const Measure*>& measures, const FrameSeries& series,
                                      std::uint64_t seed, const std::string& key);

}  // namespace jam
