#include "jamscape/stats/inflection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "jamscape/base/error.hpp"
#include "jamscape/stats/curves.hpp"
#include "jamscape/stats/least_squares.hpp"

namespace jam {
namespace {

// Parameters: a, b, c, x0, log(w - narrowest). A jump between two samples would let w go to zero and leave x0
// undefined; a quarter of the spacing as the narrowest width puts it between them.
Model logistic_plus_line(double narrowest) {
  return [narrowest](double x, std::span<const double> p, std::span<double> g) {
    const double more = std::exp(p[4]), w = narrowest + more;
    const double s = 1 / (1 + std::exp(-(x - p[3]) / w));
    const double ds = s * (1 - s) / w;
    g[0] = 1;
    g[1] = x;
    g[2] = s;
    g[3] = -p[2] * ds;
    g[4] = -p[2] * ds * (x - p[3]) / w * more;
    return p[0] + p[1] * x + p[2] * s;
  };
}

// For fixed x0 and w the model is linear in a, b, c.
std::vector<double> best_line(std::span<const double> x, std::span<const double> y, double x0, double w,
                              double& residual) {
  std::vector<double> m(9, 0.0), r(3, 0.0);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double g[3] = {1, x[k], 1 / (1 + std::exp(-(x[k] - x0) / w))};
    for (std::size_t a = 0; a < 3; ++a) {
      r[a] += g[a] * y[k];
      for (std::size_t b = 0; b < 3; ++b) m[a * 3 + b] += g[a] * g[b];
    }
  }
  std::vector<double> p = solve_linear(m, r);
  if (p.empty()) return p;
  residual = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double e = y[k] - p[0] - p[1] * x[k] - p[2] / (1 + std::exp(-(x[k] - x0) / w));
    residual += e * e;
  }
  return p;
}

std::vector<double> first_guess(std::span<const double> x, std::span<const double> y, double narrowest) {
  std::vector<double> best;
  double lowest = std::numeric_limits<double>::infinity();
  const double range = x.back() - x.front();
  for (std::size_t k = 1; k + 1 < x.size(); ++k)
    for (const double more : {0.001 * range, 0.005 * range, 0.02 * range, 0.08 * range, 0.2 * range}) {
      const double w = narrowest + more;
      double residual = 0;
      std::vector<double> p = best_line(x, y, x[k], w, residual);
      if (p.empty() || !(residual < lowest)) continue;
      lowest = residual;
      best = {p[0], p[1], p[2], x[k], std::log(more)};
    }
  return best;
}

}  // namespace

std::optional<Inflection> fit_inflection(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw data_error("a curve needs as many ordinates as abscissae");
  for (std::size_t k = 1; k < x.size(); ++k)
    if (!(x[k - 1] < x[k]))
      throw data_error("the abscissae of a curve must increase", {}, "sort the samples by abscissa");
  if (x.size() < 6) return std::nullopt;
  // In shifted and scaled abscissae the normal equations are well conditioned.
  const double middle = 0.5 * (x.front() + x.back()), half = 0.5 * (x.back() - x.front());
  std::vector<double> u(x.begin(), x.end());
  for (double& t : u) t = (t - middle) / half;
  double spacing = 2;
  for (std::size_t k = 1; k < u.size(); ++k) spacing = std::min(spacing, u[k] - u[k - 1]);
  const double narrowest = spacing / 4;
  std::vector<double> start = first_guess(u, y, narrowest);
  if (start.empty()) return std::nullopt;
  const Fit fit = least_squares(u, y, logistic_plus_line(narrowest), std::move(start), 500);
  const std::vector<double>& p = fit.parameters;
  if (!fit.converged || !(std::abs(p[3]) <= 1)) return std::nullopt;
  const double slope = p[1] / half;
  return Inflection{middle + half * p[3], half * (narrowest + std::exp(p[4])), p[2], slope, p[0] - slope * middle,
                    fit.residual};
}

Estimate inflection_of_mean(std::span<const double> x, std::span<const std::vector<double>> curves,
                            std::size_t resamples, Random& random) {
  return bootstrap(curves.size(), resamples, random, [&](std::span<const std::size_t> which) {
    const auto found = fit_inflection(x, mean_curve(curves, which));
    return found ? found->x : std::numeric_limits<double>::quiet_NaN();
  });
}

}  // namespace jam
