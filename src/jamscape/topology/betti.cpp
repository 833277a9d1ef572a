#include "jamscape/topology/betti.hpp"

#include <algorithm>
#include <numeric>

#include "jamscape/network/threshold_finder.hpp"

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

namespace {

/// `curve[k]` at sorted thresholds.
template <Level level>
std::vector<std::size_t> sorted_curve(const Diagram& diagram, int dimension, std::span<const double> sorted) {
  const ThresholdFinder finder(sorted);
  std::vector<std::size_t> ends(sorted.size() + 1,
                                0);  // classes that are there for so many thresholds, from the lowest
  for (const auto& p : pairs_of(diagram, dimension)) {
    ++ends[finder.passed<level>(p.birth)];
    ends[finder.passed<level>(p.death)] -= !p.essential;  // and no longer there
  }
  for (std::size_t k = sorted.size(); k-- > 0;) ends[k] += ends[k + 1];
  ends.erase(ends.begin());
  return ends;
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
