// What S3 reads off distributions, from the histograms of all realisations of a system added up, at its last state.
// Rows of DIR/ensemble/transitions.csv (transitions.hpp), where the measures they need were taken:
//
//   tail_k_pooled, tail_k_loglinear_pooled            exponent of P(f) beyond its mean (stats/exponential_tail.hpp)
//   peak_position_pooled, peak_prominence_pooled, type_a_pooled     whether P(f) has a peak (stats/force_tail.hpp)
//   mueth_a_pooled, mueth_b_pooled, mueth_beta_pooled Mueth's law fitted to P(f)
//   force_contacts_pooled                             contacts behind P(f)
//   rdf_peak1_pooled .. rdf_peak3_pooled              peaks of G(r), r in L (stats/shell_peaks.hpp)
//
// Errors by jackknife over the realisations (peaks of G: bootstrap); with one realisation those of the fit, or of the
// bootstrap over its grains. Source: S3 Eq. 2, Table 2; theory sec. 4.
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
