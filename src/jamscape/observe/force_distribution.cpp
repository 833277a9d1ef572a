#include "jamscape/observe/force_distribution.hpp"

#include "jamscape/base/mean.hpp"
#include "jamscape/observe/entry.hpp"
#include "jamscape/observe/wall_margin.hpp"

namespace jam {

Histogram force_distribution(const Packing& packing, const ForceNetwork& network, const MeasureOptions& options) {
  const bool linear = options.force_scale == ForceScale::linear;
  Histogram h(linear ? Spacing::linear : Spacing::logarithmic, options.force_min, options.force_max,
              static_cast<std::size_t>(options.force_bins));
  const WallMargin margin(packing, options);
  std::vector<double> forces;
  for (std::size_t e = 0; e < network.force.size(); ++e)
    if (margin.keeps(packing.contacts.point[network.contact[e]])) forces.push_back(network.force[e]);
  const double mean = mean_of(forces);
  divide_by_mean(forces, mean);
  if (mean > 0)
    for (const double f : forces) h.add(f);
  return h;
}

Measure force_distribution_measure() {
  return rows_measure(
      {"force_distribution", "distribution of the contact forces",
       "P(F): density of F/<F> over the edges of the force network, not clamped: contacts between grains, of clusters "
       "the sum over the contacts of a pair (contact_force_distribution has them singly); edges whose contact point is "
       "closer to a wall than force_margin are left out, and <F> is the mean over the rest. force_bins bins from "
       "force_min to force_max, of equal width (linear) or equal ratio (log); a bin holds its lower edge, the last "
       "both. density = count/(all edges kept x width): forces outside the bins count in the norm, so the integral "
       "over the bins is at most 1.",
       "S1 Sec. III.B, Figs. 9, 10; S2 Sec. 4.1, Fig. 3"},
      {{"force", "<F>", "centre of the bin: the geometric one for logarithmic bins"},
       {"density", "1/<F>", "P(F)"},
       {"count", "", "contacts in the bin"}},
      1, true, [](const Snapshot& s) -> std::vector<std::vector<double>> {
        const Histogram h = force_distribution(s.packing(), s.network(), s.options());
        return {h.centres(), h.density(), std::vector<double>(h.counts().begin(), h.counts().end())};
      });
}

}  // namespace jam
