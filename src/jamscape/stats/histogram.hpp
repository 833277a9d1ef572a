// Counts in bins, and the density they estimate.
//
//   density_k = count_k / (total * width_k),   total = values inside and outside the bins,
//
// so that the integral over the bins is the fraction of values that fell inside them, and 1 over the whole axis.
// A bin holds its lower edge and not its upper one, except the last, which holds both. A value on an edge to within
// round-off is on it (base/border.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace jam {

enum class Spacing { linear, logarithmic };

class Histogram {
 public:
  /// Bins between lo < hi (0 < lo for logarithmic spacing); throws a usage error otherwise.
  Histogram(Spacing spacing, double lo, double hi, std::size_t bins);

  void add(double value);  ///< a NaN is counted as outside

  std::size_t bins() const { return counts_.size(); }
  const std::vector<double>& edges() const { return edges_; }
  const std::vector<std::int64_t>& counts() const { return counts_; }
  std::int64_t below() const { return below_; }
  std::int64_t above() const { return above_; }  ///< NaNs included
  std::int64_t total() const { return total_; }

  std::vector<double> centres() const;  ///< arithmetic mean of the edges; geometric for logarithmic bins
  std::vector<double> density() const;  ///< zeros when nothing was added

 private:
  Spacing spacing_;
  std::vector<double> edges_;
  std::vector<double> from_;  // the least value on each edge
  std::vector<std::int64_t> counts_;
  std::int64_t below_ = 0, above_ = 0, total_ = 0;
};

}  // namespace jam
