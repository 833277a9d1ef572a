#include "jamscape/observe/contact_forces.hpp"

#include <algorithm>

#include "jamscape/base/border.hpp"
#include "jamscape/base/mean.hpp"
#include "jamscape/observe/entry.hpp"
#include "jamscape/observe/wall_margin.hpp"

namespace jam {
std::vector<double> contact_forces(const Packing& packing, const MeasureOptions& options) {
  const WallMargin margin(packing, options);
  const Contacts& k = packing.contacts;
  std::vector<double> forces;
  forces.reserve(k.size());
  for (std::size_t c = 0; c < k.size(); ++c)
    if (k.j[c] >= 0 && k.normal_force[c] > 0 && margin.keeps(k.point[c])) forces.push_back(k.normal_force[c]);
  return forces;
}

std::vector<std::vector<double>> distribution_columns(const std::vector<double>& values,
                                                      const MeasureOptions& options) {
  Histogram h(Spacing::linear, 0, options.contact_force_max, static_cast<std::size_t>(options.contact_force_bins));
  for (const double v : values) h.add(v);
  std::vector<double> norm;
  for (std::size_t b = 0; b < h.bins(); ++b)
    norm.push_back(static_cast<double>(h.total()) * (h.edges()[b + 1] - h.edges()[b]));
  return {h.centres(), h.density(), {h.counts().begin(), h.counts().end()}, norm};
}

Measure contact_forces_measure() {
  return frame_measure(
      {"contact_forces", "forces of single contacts",
       "F_n of every contact between bodies with F_n > 0, several contacts of two clusters each by itself; f = "
       "F_n/<F_n>, the mean over these contacts. Wall contacts are left out, and contacts whose point is closer to a "
       "wall than force_margin (0: none).",
       "S3, Contact force distributions; theory sec. 4"},
      {{"force_contacts", "", "contacts between bodies with F_n > 0"},
       {"mean_contact_force", "m d/tau_c^2", "<F_n>, mean normal force of these contacts; 0 without contacts"},
       {"fraction_above_max", "", "fraction of them with f > contact_force_max, beyond the last bin of P(f)"},
       {"fraction_above_8", "", "fraction of them with f > 8"},
       {"largest_force", "<F_n>", "largest f; 0 without contacts"}},
      [](const Snapshot& s) {
        const std::vector<double> forces = contact_forces(s.packing(), s.options());
        if (forces.empty()) return std::vector<double>(5, 0.0);
        const double average = mean_of(forces);
        double beyond_end = 0, beyond_8 = 0, largest = 0;
        for (const double f : over_mean(forces)) {
          beyond_end += exceeds(f, s.options().contact_force_max);
          beyond_8 += exceeds(f, 8);
          largest = std::max(largest, f);
        }
        const auto n = static_cast<double>(forces.size());
        return std::vector<double>{n, average, beyond_end / n, beyond_8 / n, largest};
      });
}

Measure contact_force_distribution_measure() {
  Measure m = rows_measure(
      {"contact_force_distribution", "distribution of the normal forces of single contacts",
       "P(f), f = F_n/<F_n> over the contacts between bodies with F_n > 0, several contacts of two clusters each by "
       "itself, and without those whose point is closer to a wall than force_margin; contact_force_bins equal bins "
       "from 0 "
       "to contact_force_max that hold their lower edge (the last both). density = count/norm, norm = contacts times "
       "width of the bin: forces beyond the "
       "last bin count in it, so the integral over the bins is at most 1.",
       "S3, Data analysis, Fig. 5; theory sec. 4"},
      {{"force", "<F_n>", "centre of the bin"},
       {"density", "1/<F_n>", "P(f)"},
       {"count", "", "contacts in the bin"},
       {"norm", "<F_n>", "all contacts times the width of the bin"}},
      1, true, [](const Snapshot& s) {
        return distribution_columns(over_mean(contact_forces(s.packing(), s.options())), s.options());
      });
  m.ratios = {{"density_pooled", "count", "norm", "P(f) of all contacts of all realisations, f in means of each"}};
  return m;
}

}  // namespace jam
