#include "jamscape/observe/force_network.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace jam {
namespace {

double edge_force(const Contacts& k, std::size_t c, EdgeForce which) {
  if (which == EdgeForce::normal && next_of_pair(k, c) == k.size()) return std::abs(k.normal_force[c]);
  return norm(which == EdgeForce::normal ? normal_force_of_pair(k, c) : total_force_of_pair(k, c));
}

}  // namespace

ForceNetwork force_network(const Packing& packing, const Bonds& bonds, const MeasureOptions& options) {
  const Contacts& k = packing.contacts;
  ForceNetwork net;
  WeightedGraph& g = net.graph;
  g.vertices = static_cast<std::uint32_t>(packing.grains.size());
  for (std::size_t i = 0; i < packing.grains.size(); ++i) net.grains += !options.remove_rattlers || !bonds.rattles(i);
  for (auto* ids : {&g.from, &g.to, &net.contact}) ids->resize(bonds.size() + 1);
  net.force.resize(bonds.size() + 1);
  std::size_t count = 0;
  double sum = 0;
  for (const std::uint32_t c : bonds.contact) {
    const std::uint32_t i = k.i[c], j = static_cast<std::uint32_t>(k.j[c]);
    if (options.remove_rattlers && (bonds.rattles(i) || bonds.rattles(j))) continue;
    const double f = edge_force(k, c, options.force);
    g.from[count] = i;
    g.to[count] = j;
    net.contact[count] = c;
    net.force[count] = f;
    sum += f;
    ++count;
  }
  for (auto* ids : {&g.from, &g.to, &net.contact}) ids->resize(count);
  net.force.resize(count);
  if (count > 0) net.mean_force = sum / static_cast<double>(count);
  const double scale = net.mean_force > 0 ? 1 / net.mean_force : 0;
  const double most = options.clamp > 0 ? options.clamp : std::numeric_limits<double>::infinity();
  g.weight.resize(count);
  for (std::size_t e = 0; e < count; ++e) g.weight[e] = std::min(net.force[e] * scale, most);
  return net;
}

}  // namespace jam
