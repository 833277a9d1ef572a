#include "jamscape/protocol/unbalanced.hpp"

namespace jam {

double unbalanced_part(const Packing& packing, double gravity) {
  const Contacts& k = packing.contacts;
  std::vector<Vec3> net(packing.grains.size(), Vec3{});
  for (std::size_t g = 0; g < net.size(); ++g) net[g][1] = -gravity * packing.grains.mass[g];
  double contact_sum = 0;
  for (std::size_t c = 0; c < k.size(); ++c) {
    const Vec3 f = k.tangential_force[c] - k.normal_force[c] * k.normal[c];
    contact_sum += norm(f);
    net[k.i[c]] += f;
    if (k.j[c] >= 0) net[static_cast<std::size_t>(k.j[c])] -= f;
  }
  if (!(contact_sum > 0)) return 0;
  double net_sum = 0;
  for (const Vec3& f : net) net_sum += norm(f);
  return (net_sum / static_cast<double>(net.size())) / (contact_sum / static_cast<double>(k.size()));
}

}  // namespace jam
