#include "jamscape/topology/betti.hpp"

#include <algorithm>

namespace jam {

std::size_t betti(const Diagram& diagram, int dimension, double threshold) {
  return static_cast<std::size_t>(std::count_if(diagram.pairs.begin(), diagram.pairs.end(), [&](const auto& p) {
    return p.dimension == dimension && threshold <= p.birth && (p.essential || p.death < threshold);
  }));
}

std::vector<std::size_t> betti_curve(const Diagram& diagram, int dimension, std::span<const double> thresholds) {
  std::vector<double> births, deaths;
  for (const auto& p : diagram.pairs) {
    if (p.dimension != dimension) continue;
    births.push_back(p.birth);
    if (!p.essential) deaths.push_back(p.death);
  }
  std::sort(births.begin(), births.end());
  std::sort(deaths.begin(), deaths.end());
  const auto reaching = [](const std::vector<double>& values, double threshold) {
    return static_cast<std::size_t>(values.end() - std::lower_bound(values.begin(), values.end(), threshold));
  };
  std::vector<std::size_t> curve;
  curve.reserve(thresholds.size());
  for (const double t : thresholds) curve.push_back(reaching(births, t) - reaching(deaths, t));
  return curve;
}

}  // namespace jam
