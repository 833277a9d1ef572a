#include "jamscape/observe/force_network.hpp"

#include <algorithm>
#include <cmath>

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
  for (auto* ids : {&g.from, &g.to, &net.contact}) ids->reserve(bonds.size());
  net.force.reserve(bonds.size());
  for (const std::uint32_t c : bonds.contact) {
    const std::uint32_t i = k.i[c], j = static_cast<std::uint32_t>(k.j[c]);
    if (options.remove_rattlers && (bonds.rattles(i) || bonds.rattles(j))) continue;
    g.from.push_back(i);
    g.to.push_back(j);
    net.contact.push_back(c);
    net.force.push_back(edge_force(k, c, options.force));
  }
  double sum = 0;
  for (const double f : net.force) sum += f;
  if (!net.force.empty()) net.mean_force = sum / static_cast<double>(net.force.size());
  const double scale = net.mean_force > 0 ? 1 / net.mean_force : 0;
  g.weight.resize(net.force.size());
  for (std::size_t e = 0; e < net.force.size(); ++e) {
    const double f = net.force[e] * scale;
    g.weight[e] = options.clamp > 0 ? std::min(f, options.clamp) : f;
  }
  return net;
}

}  // namespace jam
