#include "jamscape/observe/force_network.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "jamscape/base/mean.hpp"

namespace jam {
namespace {

double edge_force(const Contacts& k, std::size_t c, EdgeForce which) {
  if (which == EdgeForce::normal && next_of_pair(k, c) == k.size()) return std::abs(k.normal_force[c]);
  return norm(which == EdgeForce::normal ? normal_force_of_pair(k, c) : total_force_of_pair(k, c));
}

/// Only grains that do not rattle stay vertices, in their order.
void leave_out_rattlers(ForceNetwork& net, const Bonds& bonds) {
  WeightedGraph& g = net.graph;
  std::vector<std::uint32_t> number(g.vertices, 0);
  for (std::uint32_t grain = 0; grain < g.vertices; ++grain) {
    if (bonds.rattles(grain)) continue;
    number[grain] = static_cast<std::uint32_t>(net.grain.size());
    net.grain.push_back(grain);
  }
  for (auto* ends : {&g.from, &g.to})
    for (std::uint32_t& end : *ends) end = number[end];
  g.vertices = static_cast<std::uint32_t>(net.grain.size());
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
  for (const std::uint32_t c : bonds.contact) {
    const std::uint32_t i = k.i[c], j = static_cast<std::uint32_t>(k.j[c]);
    if (options.remove_rattlers && (bonds.rattles(i) || bonds.rattles(j))) continue;
    const double f = edge_force(k, c, options.force);
    g.from[count] = i;
    g.to[count] = j;
    net.contact[count] = c;
    net.force[count] = f;
    ++count;
  }
  for (auto* ids : {&g.from, &g.to, &net.contact}) ids->resize(count);
  net.force.resize(count);
  net.mean_force = mean_of(net.force);
  const double mean = net.mean_force;
  const double most = options.clamp > 0 ? options.clamp : std::numeric_limits<double>::infinity();
  g.weight.resize(count);
  for (std::size_t e = 0; e < count; ++e) g.weight[e] = std::min(over_mean(net.force[e], mean), most);
  if (options.remove_rattlers) leave_out_rattlers(net, bonds);
  return net;
}

}  // namespace jam
