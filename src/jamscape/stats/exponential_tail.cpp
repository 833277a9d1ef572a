#include "jamscape/stats/exponential_tail.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "jamscape/base/error.hpp"
#include "jamscape/stats/least_squares.hpp"

namespace jam {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Tail {
  std::vector<double> x, y;  // x counted from the start of the tail
};

Tail tail(std::span<const double> centre, std::span<const double> density, double from, bool with_empty) {
  if (centre.size() != density.size()) throw data_error("a distribution needs as many densities as bin centres");
  Tail t;
  for (std::size_t k = 0; k < centre.size(); ++k) {
    if (!(centre[k] > from) || !std::isfinite(density[k]) || (!with_empty && !(density[k] > 0))) continue;
    t.x.push_back(centre[k] - from);
    t.y.push_back(density[k]);
  }
  return t;
}

}  // namespace

Estimate tail_exponent(std::span<const double> centre, std::span<const double> density, double from) {
  const Tail t = tail(centre, density, from, true);
  double sum = 0, moment = 0, highest = 0;
  for (std::size_t k = 0; k < t.x.size(); ++k) {
    sum += t.y[k];
    moment += t.x[k] * t.y[k];
    highest = std::max(highest, t.y[k]);
  }
  if (t.x.size() < 3 || !(moment > 0)) return {none, none, t.x.size()};
  const Model exponential = [](double x, std::span<const double> p, std::span<double> gradient) {
    const double e = std::exp(-p[1] * x);
    gradient[0] = e;
    gradient[1] = -p[0] * x * e;
    return p[0] * e;
  };
  const Fit fit = least_squares(t.x, t.y, exponential, {highest, sum / moment});
  if (!fit.converged) return {none, none, t.x.size()};
  return {fit.parameters[1], fit.errors[1], t.x.size()};
}

Estimate tail_exponent_loglinear(std::span<const double> centre, std::span<const double> density, double from) {
  const Tail t = tail(centre, density, from, false);
  const auto n = static_cast<double>(t.x.size());
  if (n < 3) return {none, none, t.x.size()};
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0, residual = 0;
  for (std::size_t k = 0; k < t.x.size(); ++k) {
    mean_x += t.x[k] / n;
    mean_y += std::log(t.y[k]) / n;
  }
  for (std::size_t k = 0; k < t.x.size(); ++k) {
    xx += (t.x[k] - mean_x) * (t.x[k] - mean_x);
    xy += (t.x[k] - mean_x) * (std::log(t.y[k]) - mean_y);
  }
  const double slope = xy / xx;
  for (std::size_t k = 0; k < t.x.size(); ++k) {
    const double r = std::log(t.y[k]) - mean_y - slope * (t.x[k] - mean_x);
    residual += r * r;
  }
  return {-slope, std::sqrt(residual / (n - 2) / xx), t.x.size()};
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
    if (!(f > from)) continue;
    ++n;
    excess += f - from;
  }
  return tail_exponent_likelihood(n, excess);
}

}  // namespace jam
