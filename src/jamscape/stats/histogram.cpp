#include "jamscape/stats/histogram.hpp"

#include <algorithm>
#include <cmath>

#include "jamscape/base/border.hpp"
#include "jamscape/base/error.hpp"

namespace jam {

Histogram::Histogram(Spacing spacing, double lo, double hi, std::size_t bins) : spacing_(spacing), counts_(bins, 0) {
  if (bins == 0) throw usage_error("a histogram needs at least one bin");
  if (!(lo < hi) || !std::isfinite(lo) || !std::isfinite(hi))
    throw usage_error("the range of a histogram is empty or not finite", {}, "give a lower edge below the upper one");
  if (spacing == Spacing::logarithmic && lo <= 0)
    throw usage_error("logarithmic bins cannot start at zero or below", {}, "give a positive lower edge");
  edges_.resize(bins + 1);
  const auto n = static_cast<double>(bins);
  for (std::size_t k = 0; k <= bins; ++k) {
    const double s = static_cast<double>(k) / n;
    edges_[k] = spacing == Spacing::linear ? lo + s * (hi - lo) : lo * std::pow(hi / lo, s);
  }
  edges_.front() = lo;
  edges_.back() = hi;
  for (const double edge : edges_) from_.push_back(on_from(edge));
}

void Histogram::add(double value) {
  ++total_;
  if (value < from_.front()) {
    ++below_;
  } else if (value < from_.back()) {
    const auto upper = std::upper_bound(from_.begin(), from_.end(), value);
    ++counts_[static_cast<std::size_t>(upper - from_.begin()) - 1];
  } else if (value <= on_to(edges_.back())) {
    ++counts_.back();
  } else {
    ++above_;
  }
}

std::vector<double> Histogram::centres() const {
  std::vector<double> c(bins());
  for (std::size_t k = 0; k < bins(); ++k)
    c[k] = spacing_ == Spacing::linear ? 0.5 * (edges_[k] + edges_[k + 1]) : std::sqrt(edges_[k] * edges_[k + 1]);
  return c;
}

std::vector<double> Histogram::density() const {
  std::vector<double> d(bins(), 0.0);
  if (total_ == 0) return d;
  for (std::size_t k = 0; k < bins(); ++k)
    d[k] = static_cast<double>(counts_[k]) / (static_cast<double>(total_) * (edges_[k + 1] - edges_[k]));
  return d;
}

}  // namespace jam
