#include "jamscape/observe/force_distribution.hpp"

#include "jamscape/base/mean.hpp"
#include "jamscape/observe/entry.hpp"

namespace jam {

Histogram force_distribution(const ForceNetwork& network, const MeasureOptions& options) {
  const bool linear = options.force_scale == ForceScale::linear;
  Histogram h(linear ? Spacing::linear : Spacing::logarithmic, options.force_min, options.force_max,
              static_cast<std::size_t>(options.force_bins));
  if (network.mean_force > 0)
    for (const double f : over_mean(network.force)) h.add(f);
  return h;
}

Measure force_distribution_measure() {
  return rows_measure(
      {"force_distribution", "distribution of the contact forces",
       "P(F): density of F/<F> over the edges of the force network, not clamped: contacts between grains, of clusters "
       "the sum over the contacts of a pair (contact_force_distribution has them singly). Forces outside the bins "
       "count in the norm, so the integral over the bins is at most 1.",
       "S1 Sec. III.B, Figs. 9, 10; S2 Sec. 4.1, Fig. 3"},
      {{"force", "<F>", "centre of the bin: the geometric one for logarithmic bins"},
       {"density", "1/<F>", "P(F)"},
       {"count", "", "contacts in the bin"}},
      1, true, [](const Snapshot& s) -> std::vector<std::vector<double>> {
        const Histogram h = force_distribution(s.network(), s.options());
        return {h.centres(), h.density(), std::vector<double>(h.counts().begin(), h.counts().end())};
      });
}

}  // namespace jam
