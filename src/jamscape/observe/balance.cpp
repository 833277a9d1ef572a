#include "jamscape/observe/balance.hpp"

#include "jamscape/observe/entry.hpp"

namespace jam {

namespace {

/// In the plane two of the three components.
template <int D>
double ratio_of_means(const Packing& packing) {
  const Contacts& k = packing.contacts;
  std::vector<Vec<D>> net(packing.grains.size(), Vec<D>{});
  double contact_sum = 0;
  for (std::size_t c = 0; c < k.size(); ++c) {
    Vec<D> f;
    for (int a = 0; a < D; ++a) f[a] = k.tangential_force[c][a] - k.normal_force[c] * k.normal[c][a];
    contact_sum += norm(f);
    net[k.i[c]] += f;
    if (k.j[c] >= 0) net[static_cast<std::size_t>(k.j[c])] -= f;
  }
  if (!(contact_sum > 0)) return 0;
  double net_sum = 0;
  for (const Vec<D>& f : net) net_sum += norm(f);
  return (net_sum / static_cast<double>(net.size())) / (contact_sum / static_cast<double>(k.size()));
}

}  // namespace

double unbalanced_force(const Packing& packing) {
  return packing.dimension == 2 ? ratio_of_means<2>(packing) : ratio_of_means<3>(packing);
}

Measure balance_measure() {
  return frame_measure(
      {"balance", "unbalanced force",
       "(mean over grains of |sum of contact forces|)/(mean over contacts of |contact force|), wall contacts "
       "included; 0 at rest, and without contacts. Gravity is no contact force: under it a packing at rest has the "
       "weight of "
       "a grain over the mean contact force.",
       "theory sec. 1; as in Yade"},
      {{"unbalanced_force", "", "mean net force on a grain over the mean contact force"}},
      [](const Snapshot& s) { return std::vector<double>{unbalanced_force(s.packing())}; });
}

}  // namespace jam
