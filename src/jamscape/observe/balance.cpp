#include "jamscape/observe/balance.hpp"

#include <limits>

#include "jamscape/observe/entry.hpp"

namespace jam {

namespace {

/// In the plane two of the three components.
template <int D>
double ratio_of_means(const Packing& packing, double gravity) {
  const Contacts& k = packing.contacts;
  std::vector<Vec<D>> net(packing.grains.size(), Vec<D>{});
  for (std::size_t g = 0; gravity != 0 && g < net.size(); ++g) net[g][1] = -gravity * packing.grains.mass[g];
  double contact_sum = 0;
  std::size_t contacts = 0;
  for (std::size_t c = 0; c < k.size(); ++c) {
    Vec<D> f;
    for (int a = 0; a < D; ++a) f[a] = k.tangential_force[c][a] - k.normal_force[c] * k.normal[c][a];
    const double size = norm(f);
    contact_sum += size;
    contacts += size > 0 || touches(k, c);
    net[k.i[c]] += f;
    if (k.j[c] >= 0) net[static_cast<std::size_t>(k.j[c])] -= f;
  }
  if (!(contact_sum > 0)) return std::numeric_limits<double>::quiet_NaN();
  double net_sum = 0;
  for (const Vec<D>& f : net) net_sum += norm(f);
  return (net_sum / static_cast<double>(net.size())) / (contact_sum / static_cast<double>(contacts));
}

}  // namespace

double unbalanced_force(const Packing& packing, double gravity) {
  return packing.dimension == 2 ? ratio_of_means<2>(packing, gravity) : ratio_of_means<3>(packing, gravity);
}

Measure balance_measure() {
  return frame_measure(
      {"balance", "unbalanced force",
       "(mean over grains of |sum of its contact forces + its weight|)/(mean over contacts of |contact force|), wall "
       "contacts included in both, every contact with overlap >= 0 or a force by itself; the weight is m g down the "
       "second axis, g of the study (domain.gravity) or the option measure.gravity. 0 at rest, missing where no "
       "contact "
       "carries a force.",
       "theory sec. 1; as in Yade"},
      {{"unbalanced_force", "", "mean net force on a grain over the mean contact force"}},
      [](const Snapshot& s) { return std::vector<double>{unbalanced_force(s.packing(), s.options().gravity)}; });
}

}  // namespace jam
