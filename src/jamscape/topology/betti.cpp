#include "jamscape/topology/betti.hpp"

#include <algorithm>
#include <numeric>

namespace jam {
namespace {

/// Whether a cell of this value is in the level set.
bool holds(double value, double threshold, Level level) {
  return level == Level::at_least ? value >= threshold : value > threshold;
}

}  // namespace

std::size_t betti(const Diagram& diagram, int dimension, double threshold, Level level) {
  return static_cast<std::size_t>(std::count_if(diagram.pairs.begin(), diagram.pairs.end(), [&](const auto& p) {
    return p.dimension == dimension && holds(p.birth, threshold, level) &&
           (p.essential || !holds(p.death, threshold, level));
  }));
}

std::vector<std::size_t> betti_curve(const Diagram& diagram, int dimension, std::span<const double> thresholds,
                                     Level level) {
  std::vector<std::size_t> order(thresholds.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return thresholds[a] < thresholds[b]; });
  std::vector<double> sorted;
  for (const std::size_t k : order) sorted.push_back(thresholds[k]);
  // How many thresholds, from the lowest on, a cell of this value is there for.
  const auto reach = [&](double value) {
    const auto end = level == Level::at_least ? std::upper_bound(sorted.begin(), sorted.end(), value)
                                              : std::lower_bound(sorted.begin(), sorted.end(), value);
    return static_cast<std::size_t>(end - sorted.begin());
  };
  std::vector<std::size_t> born(sorted.size() + 1, 0), dead(sorted.size() + 1, 0);
  for (const auto& p : diagram.pairs) {
    if (p.dimension != dimension) continue;
    ++born[reach(p.birth)];
    if (!p.essential) ++dead[reach(p.death)];
  }
  std::vector<std::size_t> curve(thresholds.size());
  std::size_t there = 0;
  for (std::size_t k = sorted.size(); k-- > 0;) {
    there += born[k + 1] - dead[k + 1];
    curve[order[k]] = there;
  }
  return curve;
}

}  // namespace jam
