#include "jamscape/stats/shell_peaks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "jamscape/base/border.hpp"
#include "jamscape/base/error.hpp"
#include "jamscape/stats/curves.hpp"
#include "jamscape/stats/none.hpp"

namespace jam {
namespace {

constexpr double kErrorsOfAPeak = 4;    // between the extremes of some 50 bins chance makes 3
constexpr double kLeastProminence = 0.05;  // of g; smaller ones are seen in no printed curve

/// Mean over a bin and its neighbours, with the error of the counts.
struct Smooth {
  std::vector<double> g, error;
};

Smooth smooth(std::span<const double> pairs, std::span<const double> ideal) {
  Smooth s;
  for (std::size_t k = 0; k < pairs.size() && ideal[k] > 0; ++k) {
    s.g.push_back(pairs[k] / ideal[k]);
    s.error.push_back(2 * pairs[k] / (ideal[k] * ideal[k]));  // variance: a pair counts twice
  }
  const Smooth raw = s;
  for (std::size_t k = 0; k < s.g.size(); ++k) {
    const std::size_t from = k > 0 ? k - 1 : 0, to = std::min(k + 2, s.g.size());
    double sum = 0, variance = 0;
    for (std::size_t b = from; b < to; ++b) sum += raw.g[b], variance += raw.error[b];
    s.g[k] = sum / static_cast<double>(to - from);
    s.error[k] = std::sqrt(variance) / static_cast<double>(to - from);
  }
  return s;
}

class Curve {
 public:
  Curve(std::span<const double> distance, Smooth smooth) : r_(distance), s_(std::move(smooth)) {}

  /// The highest bin with lo <= r <= hi that stands out; the middle one of equals; NaN if there is none.
  double peak(double lo, double hi, double shell) const {
    std::size_t at = s_.g.size(), last = at;
    for (std::size_t k = 0; k < s_.g.size(); ++k) {
      if (!reaches(r_[k], lo) || exceeds(r_[k], hi)) continue;
      if (at == s_.g.size() || exceeds(s_.g[k], s_.g[at])) {
        at = last = k;
      } else if (k == last + 1 && reaches(s_.g[k], s_.g[at])) {
        last = k;
      }
    }
    if (at == s_.g.size()) return none;
    at = (at + last) / 2;
    const double half = (shell > 0 ? shell : r_[at]) / 2;
    return stands_out(at, r_[at] - half, r_[at]) && stands_out(at, r_[at], r_[at] + half) ? place(at) : none;
  }

 private:
  bool stands_out(std::size_t at, double lo, double hi) const {
    std::size_t low = at;
    for (std::size_t k = 0; k < s_.g.size(); ++k)
      if (reaches(r_[k], lo) && !exceeds(r_[k], hi) && s_.g[k] < s_.g[low]) low = k;
    const double drop = s_.g[at] - s_.g[low];
    return drop > kLeastProminence && drop > kErrorsOfAPeak * std::hypot(s_.error[at], s_.error[low]);
  }

  double place(std::size_t at) const {
    if (at == 0 || at + 1 >= s_.g.size()) return r_[at];
    const double left = s_.g[at - 1], right = s_.g[at + 1], bend = left - 2 * s_.g[at] + right;
    if (!(bend < 0)) return r_[at];
    return r_[at] + std::clamp(0.5 * (left - right) / bend, -0.5, 0.5) * (r_[at] - r_[at - 1]);
  }

  std::span<const double> r_;
  Smooth s_;
};

}  // namespace

std::array<double, 3> shell_peaks(std::span<const double> distance, std::span<const double> pairs,
                                  std::span<const double> ideal) {
  if (distance.size() != pairs.size() || distance.size() != ideal.size())
    throw data_error("a radial distribution needs as many pair counts as distances");
  const Curve curve(distance, smooth(pairs, ideal));
  const double first = curve.peak(0, std::numeric_limits<double>::infinity(), 0);
  if (std::isnan(first)) return {none, none, none};
  return {first, curve.peak(1.5 * first, 2.5 * first, first), curve.peak(2.5 * first, 3.5 * first, first)};
}

std::array<Estimate, 3> shell_peaks(std::span<const double> distance, std::span<const std::vector<double>> pairs,
                                    std::span<const std::vector<double>> ideal, std::size_t resamples, Random& random) {
  const std::size_t n = pairs.size();
  std::array<Estimate, 3> result;
  result.fill({none, none, n});
  if (n == 0) return result;
  std::vector<std::size_t> drawn(n);
  std::iota(drawn.begin(), drawn.end(), std::size_t{0});
  const auto peaks = [&] { return shell_peaks(distance, sum_of_curves(pairs, drawn), sum_of_curves(ideal, drawn)); };
  const std::array<double, 3> all = peaks();
  for (std::size_t p = 0; p < 3; ++p) result[p].value = all[p];
  if (n < 2 || std::isnan(all[0])) return result;
  std::array<std::vector<double>, 3> found;
  for (std::size_t r = 0; r < resamples; ++r) {
    for (std::size_t& k : drawn) k = static_cast<std::size_t>(random.below(n));
    const std::array<double, 3> at = peaks();
    for (std::size_t p = 0; p < 3; ++p)
      if (!std::isnan(at[p])) found[p].push_back(at[p]);
  }
  for (std::size_t p = 0; p < 3; ++p)
    if (!std::isnan(all[p]) && 2 * found[p].size() >= resamples) result[p].error = bootstrap_error(n, found[p]);
  return result;
}

}  // namespace jam
