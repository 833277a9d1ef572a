#include "jamscape/network/level_tally.hpp"

#include <bit>

namespace jam {

double ShapeSum::sum() {
  double s = 0;
  for (std::size_t word = 0; word < used_.size(); ++word)
    for (auto bits = used_[word]; bits != 0; bits &= bits - 1) {
      const auto vertices = 64 * word + static_cast<std::size_t>(std::countr_zero(bits));
      if (edges_[vertices] == 0) used_[word] ^= bits & (0 - bits);
      s += static_cast<double>(edges_[vertices]) / static_cast<double>(vertices);
    }
  return s;
}

ClusterLevel LevelTally::level() {
  ClusterLevel now;
  now.clusters = count_ - through_count_;
  now.cluster_vertices = vertices_ - through_vertices_;
  now.percolating_clusters = through_count_;
  now.percolating_vertices = through_vertices_;
  for (std::size_t a = 0; a < 3; ++a) now.percolates[a] = (through_ >> (2 * a) & 1u) != 0;
  const auto all = now.clusters + now.percolating_clusters;
  if (all > 0) now.shape = shapes_.sum() / all;
  return now;
}

}  // namespace jam
