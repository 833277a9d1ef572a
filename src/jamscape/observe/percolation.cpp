#include "jamscape/observe/percolation.hpp"

#include <limits>
#include <numeric>

#include "jamscape/observe/entry.hpp"
#include "jamscape/observe/ratio.hpp"

namespace jam {
namespace {

/// Edges of positive force of each grain: those without force are the last.
std::vector<std::uint32_t> degrees(const ComponentHistory& history) {
  std::vector<std::uint32_t> degree(history.degree().begin(), history.degree().end());
  for (std::uint32_t r = history.edges(); r-- > 0 && history.weight(r) == 0;) {
    --degree[history.ends()[r].a];
    --degree[history.ends()[r].b];
  }
  return degree;
}

}  // namespace

double percolation_estimate(const std::vector<std::uint32_t>& degree) {
  std::uint64_t sum = 0, pairs = 0;
  for (const std::uint64_t k : degree) {
    sum += k;
    pairs += k * (k - 1);  // 0 for k = 0
  }
  return pairs > 0 ? static_cast<double>(sum) / static_cast<double>(pairs) : std::numeric_limits<double>::quiet_NaN();
}

Measure percolation_measure() {
  return frame_measure(
      {"percolation", "percolation of the force network",
       "Clusters of the network of forces F > 0 that join two opposite walls, or wind around a periodic box. "
       "A wall is touched through a contact of positive normal force. N all grains; k over the vertices of the "
       "network. "
       "percolation_estimate = <k>/(<k^2> - <k>), k the contacts of a grain in the network: the fraction of vertices "
       "that a random network needs to percolate; missing where no grain has two.",
       "S2 Sec. 4.3, Eq. 6; theory sec. 4"},
      {{"percolates_x", "", "1 where a cluster percolates along x"},
       {"percolates_y", "", "1 where a cluster percolates along y"},
       {"percolates_z", "", "1 where a cluster percolates along z; 0 in two dimensions"},
       {"percolates", "", "1 where a cluster percolates along any axis"},
       {"percolating_fraction", "", "N_per/N, grains in percolating clusters; 0 without",
        Averaging::nonzero_or_missing},
       {"percolation_estimate", "", "fraction of grains that a random network with these contacts needs"},
       {"mean_degree", "", "2 edges/grains, those of positive force; grains without rattlers where they are removed"}},
      [](const Snapshot& s) {
        const ClusterLevel& whole = s.levels().front();
        const auto degree = degrees(s.history());
        const auto ends = static_cast<double>(std::accumulate(degree.begin(), degree.end(), std::uint64_t{0}));
        std::vector<double> row(whole.percolates.begin(), whole.percolates.end());
        row.push_back(whole.percolating_clusters > 0 ? 1 : 0);
        row.push_back(ratio(whole.percolating_vertices, static_cast<double>(s.packing().grains.size())));
        row.push_back(percolation_estimate(degree));
        row.push_back(ratio(ends, static_cast<double>(s.network().grains)));
        return row;
      });
}

}  // namespace jam
