#include "jamscape/stats/inflection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "jamscape/base/error.hpp"
#include "jamscape/stats/curves.hpp"
#include "jamscape/stats/least_squares.hpp"

namespace jam {
namespace {

// Parameters: a, b, c, x0, log(w - narrowest), and d where the slopes differ. A jump between two samples would let w go
// to zero and leave x0 undefined; a quarter of the spacing as the narrowest width puts it between them.
Model logistic_plus_line(double narrowest) {
  return [narrowest](double x, std::span<const double> p, std::span<double> g) {
    const double more = std::exp(p[4]), w = narrowest + more, u = x - p[3], d = p.size() > 5 ? p[5] : 0;
    const double s = 1 / (1 + std::exp(-u / w)), jump = p[2] + d * u;
    const double ds = s * (1 - s) / w;
    g[0] = 1;
    g[1] = x;
    g[2] = s;
    g[3] = -jump * ds - d * s;
    g[4] = -jump * ds * u / w * more;
    if (p.size() > 5) g[5] = u * s;
    return p[0] + p[1] * x + jump * s;
  };
}

// For fixed x0 and w the model is linear in a, b, c, d; `parameters` is 5 or 6.
std::vector<double> best_line(std::span<const double> x, std::span<const double> y, double x0, double w,
                              std::size_t parameters, double& residual) {
  const std::size_t n = parameters - 2;
  const auto terms = [&](double at) {
    const double s = 1 / (1 + std::exp(-(at - x0) / w));
    return std::array<double, 4>{1, at, s, (at - x0) * s};
  };
  std::vector<double> m(n * n, 0.0), r(n, 0.0);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const auto g = terms(x[k]);
    for (std::size_t a = 0; a < n; ++a) {
      r[a] += g[a] * y[k];
      for (std::size_t b = 0; b < n; ++b) m[a * n + b] += g[a] * g[b];
    }
  }
  std::vector<double> p = solve_linear(m, r);
  if (p.empty()) return p;
  residual = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const auto g = terms(x[k]);
    double e = y[k];
    for (std::size_t a = 0; a < n; ++a) e -= p[a] * g[a];
    residual += e * e;
  }
  return p;
}

std::vector<double> first_guess(std::span<const double> x, std::span<const double> y, double narrowest,
                                std::size_t parameters) {
  std::vector<double> best;
  double lowest = std::numeric_limits<double>::infinity();
  const double range = x.back() - x.front();
  for (std::size_t k = 1; k + 1 < x.size(); ++k)
    for (const double more : {0.001 * range, 0.005 * range, 0.02 * range, 0.08 * range, 0.2 * range}) {
      const double w = narrowest + more;
      double residual = 0;
      std::vector<double> p = best_line(x, y, x[k], w, parameters, residual);
      if (p.empty() || !(residual < lowest)) continue;
      lowest = residual;
      best = {p[0], p[1], p[2], x[k], std::log(more)};
      if (parameters > 5) best.push_back(p[3]);
    }
  return best;
}

/// The distance of the two samples that x lies between.
double gap_at(std::span<const double> samples, double x) {
  const auto above = std::upper_bound(samples.begin() + 1, samples.end() - 1, x);
  return *above - *(above - 1);
}

}  // namespace

std::optional<Inflection> fit_inflection(std::span<const double> x, std::span<const double> y, Slopes slopes) {
  if (x.size() != y.size()) throw data_error("a curve needs as many ordinates as abscissae");
  for (std::size_t k = 1; k < x.size(); ++k)
    if (!(x[k - 1] < x[k]))
      throw data_error("the abscissae of a curve must increase", {}, "sort the samples by abscissa");
  const std::size_t parameters = slopes == Slopes::equal ? 5 : 6;
  if (x.size() <= parameters) return std::nullopt;
  // In shifted and scaled abscissae the normal equations are well conditioned.
  const double middle = 0.5 * (x.front() + x.back()), half = 0.5 * (x.back() - x.front());
  std::vector<double> u(x.begin(), x.end());
  for (double& t : u) t = (t - middle) / half;
  double spacing = 2;
  for (std::size_t k = 1; k < u.size(); ++k) spacing = std::min(spacing, u[k] - u[k - 1]);
  const double narrowest = spacing / 4;
  std::vector<double> start = first_guess(u, y, narrowest, parameters);
  if (start.empty()) return std::nullopt;
  const Fit fit = least_squares(u, y, logistic_plus_line(narrowest), std::move(start), 2000);
  const std::vector<double>& p = fit.parameters;
  if (!fit.converged || !(std::abs(p[3]) <= 1)) return std::nullopt;
  Inflection found;
  found.x = middle + half * p[3];
  found.width = half * (narrowest + std::exp(p[4]));
  found.height = p[2];
  found.slope = p[1] / half;
  found.gain = parameters > 5 ? p[5] / half : 0;
  found.offset = p[0] - found.slope * middle;
  found.y = p[0] + p[1] * p[3] + p[2] / 2;
  found.residual = fit.residual;
  const double h = gap_at(x, found.x), unresolved = std::clamp(2 - 4 * found.width / h, 0.0, 1.0);
  found.resolution = unresolved * h / std::sqrt(12.0);
  return found;
}

Estimate inflection_of_mean(std::span<const double> x, std::span<const std::vector<double>> curves,
                            std::size_t resamples, Random& random, Slopes slopes) {
  Estimate e = bootstrap(curves.size(), resamples, random, [&](std::span<const std::size_t> which) {
    const auto found = fit_inflection(x, mean_curve(curves, which), slopes);
    return found ? found->x : std::numeric_limits<double>::quiet_NaN();
  });
  std::vector<std::size_t> all(curves.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  if (std::isfinite(e.value))
    e.error = std::hypot(e.error, fit_inflection(x, mean_curve(curves, all), slopes)->resolution);
  return e;
}

}  // namespace jam
