#include "jamscape/stats/exponential_tail.hpp"

#include <cmath>
#include <vector>

#include "jamscape/base/border.hpp"
#include "jamscape/base/error.hpp"
#include "jamscape/stats/least_squares.hpp"
#include "jamscape/stats/none.hpp"

namespace jam {
namespace {

constexpr double kSlowest = 0.02, kFastest = 100;  // of k: flat over all bins; gone within one

struct Tail {
  std::vector<double> x, y, variance;  // x counted from the start of the tail
  std::size_t filled = 0;              // bins that hold something
};

enum class Empty { kept, left_out };

Tail tail(std::span<const double> centre, std::span<const double> count, std::span<const double> norm, double from,
          Empty empty) {
  if (centre.size() != count.size() || centre.size() != norm.size())
    throw data_error("a distribution needs as many counts and norms as bin centres");
  Tail t;
  for (std::size_t k = 0; k < centre.size(); ++k) {
    if (!exceeds(centre[k], from) || !std::isfinite(count[k]) || !(norm[k] > 0)) continue;
    if (empty == Empty::left_out && !(count[k] > 0)) continue;
    t.x.push_back(centre[k] - from);
    t.y.push_back(count[k] / norm[k]);
    t.variance.push_back(count[k] / (norm[k] * norm[k]));
    t.filled += count[k] > 0;
  }
  return t;
}

}  // namespace

Estimate tail_exponent(std::span<const double> centre, std::span<const double> count, std::span<const double> norm,
                       double from) {
  const Tail t = tail(centre, count, norm, from, Empty::kept);
  if (t.x.size() < 3 || t.filled < 2) return {none, none, t.x.size()};
  const Model exponential = [](double x, std::span<const double> p, std::span<double> gradient) {
    const double e = std::exp(-p[1] * x);
    gradient[0] = e;
    gradient[1] = -p[0] * x * e;
    return p[0] * e;
  };
  const Terms fall = [](double x, double k, std::span<double> factor) { factor[0] = std::exp(-k * x); };
  const auto fit = separable_fit(t.x, t.y, fall, 1, geometric_grid(kSlowest, kFastest, 60));
  if (!fit) return {none, none, t.x.size()};
  const std::vector<double> parameters = {fit->linear[0], fit->q};
  const std::vector<double> errors = propagated_errors(t.x, t.variance, exponential, parameters);
  return {fit->q, errors.empty() ? none : errors[1], t.x.size()};
}

Estimate tail_exponent_loglinear(std::span<const double> centre, std::span<const double> count,
                                 std::span<const double> norm, double from) {
  const Tail t = tail(centre, count, norm, from, Empty::left_out);
  const auto n = static_cast<double>(t.x.size());
  if (n < 3) return {none, none, t.x.size()};
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0, variance = 0;
  for (std::size_t k = 0; k < t.x.size(); ++k) {
    mean_x += t.x[k] / n;
    mean_y += std::log(t.y[k]) / n;
  }
  for (std::size_t k = 0; k < t.x.size(); ++k) {
    const double u = t.x[k] - mean_x;
    xx += u * u;
    xy += u * (std::log(t.y[k]) - mean_y);
    variance += u * u * t.variance[k] / (t.y[k] * t.y[k]);
  }
  return {-xy / xx, std::sqrt(variance) / xx, t.x.size()};
}

Estimate tail_exponent_likelihood(std::size_t n, double excess) {
  if (n == 0 || !(excess > 0)) return {none, none, n};
  const double k = static_cast<double>(n) / excess;
  return {k, n < 2 ? none : k / std::sqrt(static_cast<double>(n)), n};
}

Estimate tail_exponent_likelihood(std::span<const double> sample, double from) {
  std::size_t n = 0;
  double excess = 0;
  for (const double f : sample) {
    if (!exceeds(f, from)) continue;
    ++n;
    excess += f - from;
  }
  return tail_exponent_likelihood(n, excess);
}

}  // namespace jam
