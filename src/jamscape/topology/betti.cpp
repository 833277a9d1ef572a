#include "jamscape/topology/betti.hpp"

#include <algorithm>
#include <numeric>

#include "jamscape/network/threshold_finder.hpp"

namespace jam {
std::size_t betti(const Diagram& diagram, int dimension, double threshold, Level level) {
  return static_cast<std::size_t>(std::count_if(diagram.pairs.begin(), diagram.pairs.end(), [&](const auto& p) {
    return p.dimension == dimension && keeps(level, p.birth, threshold) &&
           (p.essential || !keeps(level, p.death, threshold));
  }));
}

namespace {

/// `curve[k]` at sorted thresholds: classes born by then, less those that have died.
template <Level level>
std::vector<std::size_t> sorted_curve(const Diagram& diagram, int dimension, std::span<const double> sorted) {
  const std::vector<double> least = bars(level, sorted);
  const ThresholdFinder finder(least);
  const auto pairs = pairs_of(diagram, dimension);
  const auto holds = [&](double value, std::size_t k) {
    return level == Level::at_least ? value >= least[k] : value > least[k];
  };
  std::vector<std::size_t> deaths(sorted.size() + 1, 0);  // by the number of thresholds that they pass
  for (const auto& p : pairs) deaths[finder.passed<level>(p.death)] += !p.essential;
  std::vector<std::size_t> curve(sorted.size());
  std::size_t born = 0, dead = 0;
  for (std::size_t k = sorted.size(); k-- > 0;) {
    while (born < pairs.size() && holds(pairs[born].birth, k)) ++born;  // births decrease
    dead += deaths[k + 1];
    curve[k] = born - dead;
  }
  return curve;
}

}  // namespace

std::vector<std::size_t> betti_curve(const Diagram& diagram, int dimension, std::span<const double> thresholds,
                                     Level level) {
  const auto at_sorted = [&](std::span<const double> sorted) {
    return level == Level::at_least ? sorted_curve<Level::at_least>(diagram, dimension, sorted)
                                    : sorted_curve<Level::above>(diagram, dimension, sorted);
  };
  if (std::is_sorted(thresholds.begin(), thresholds.end())) return at_sorted(thresholds);
  std::vector<std::size_t> order(thresholds.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return thresholds[a] < thresholds[b]; });
  std::vector<double> sorted;
  for (const std::size_t k : order) sorted.push_back(thresholds[k]);
  const auto there = at_sorted(sorted);
  std::vector<std::size_t> curve(thresholds.size());
  for (std::size_t k = 0; k < order.size(); ++k) curve[order[k]] = there[k];
  return curve;
}

}  // namespace jam
