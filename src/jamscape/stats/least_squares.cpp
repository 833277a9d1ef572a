#include "jamscape/stats/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

struct NormalEquations {
  std::vector<double> matrix;  // J^T J, row-major
  std::vector<double> right;   // J^T (y - model)
  double residual = 0;
};

NormalEquations linearise(std::span<const double> x, std::span<const double> y, const Model& model,
                          std::span<const double> p) {
  const std::size_t m = p.size();
  NormalEquations e{std::vector<double>(m * m, 0.0), std::vector<double>(m, 0.0), 0.0};
  std::vector<double> g(m);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double r = y[k] - model(x[k], p, g);
    e.residual += r * r;
    for (std::size_t a = 0; a < m; ++a) {
      e.right[a] += g[a] * r;
      for (std::size_t b = 0; b < m; ++b) e.matrix[a * m + b] += g[a] * g[b];
    }
  }
  // A parameter that no longer matters would make the equations singular; with a floor it just stays where it is.
  double largest = 0;
  for (std::size_t a = 0; a < m; ++a) largest = std::max(largest, e.matrix[a * m + a]);
  for (std::size_t a = 0; a < m; ++a) e.matrix[a * m + a] = std::max(e.matrix[a * m + a], 1e-20 * largest);
  return e;
}

std::vector<double> standard_errors(const NormalEquations& e, std::size_t points) {
  const std::size_t m = e.right.size();
  std::vector<double> errors(m, std::numeric_limits<double>::quiet_NaN());
  if (points <= m) return errors;
  const double variance = e.residual / static_cast<double>(points - m);
  for (std::size_t a = 0; a < m; ++a) {
    std::vector<double> unit(m, 0.0);
    unit[a] = 1;
    const std::vector<double> column = solve_linear(e.matrix, unit);
    if (!column.empty() && column[a] >= 0) errors[a] = std::sqrt(variance * column[a]);
  }
  return errors;
}

// What an undamped step promises to take off the residual.
double left_to_gain(const NormalEquations& e) {
  const std::vector<double> step = solve_linear(e.matrix, e.right);
  if (step.empty()) return std::numeric_limits<double>::infinity();
  double gain = 0;
  for (std::size_t a = 0; a < step.size(); ++a) gain += step[a] * e.right[a];
  return std::abs(gain);
}

}  // namespace

std::vector<double> solve_linear(std::vector<double> a, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c + 1; r < n; ++r)
      if (std::abs(a[r * n + c]) > std::abs(a[pivot * n + c])) pivot = r;
    if (!(std::abs(a[pivot * n + c]) > 0)) return {};
    for (std::size_t k = 0; k < n; ++k) std::swap(a[c * n + k], a[pivot * n + k]);
    std::swap(b[c], b[pivot]);
    for (std::size_t r = c + 1; r < n; ++r) {
      const double f = a[r * n + c] / a[c * n + c];
      for (std::size_t k = c; k < n; ++k) a[r * n + k] -= f * a[c * n + k];
      b[r] -= f * b[c];
    }
  }
  for (std::size_t c = n; c-- > 0;) {
    for (std::size_t k = c + 1; k < n; ++k) b[c] -= a[c * n + k] * b[k];
    b[c] /= a[c * n + c];
  }
  return b;
}

Fit least_squares(std::span<const double> x, std::span<const double> y, const Model& model, std::vector<double> start,
                  int max_iterations) {
  if (x.size() != y.size()) throw data_error("a fit needs as many ordinates as abscissae");
  if (x.size() < start.size()) throw data_error("a fit needs at least as many points as parameters");
  const std::size_t m = start.size();
  Fit fit;
  fit.parameters = std::move(start);
  NormalEquations e = linearise(x, y, model, fit.parameters);
  double size = 0;
  for (const double v : y) size += v * v;
  double lambda = 1e-3;
  for (fit.iterations = 0; fit.iterations < max_iterations && !fit.converged; ++fit.iterations) {
    std::vector<double> damped = e.matrix;
    for (std::size_t a = 0; a < m; ++a) damped[a * m + a] *= 1 + lambda;
    const std::vector<double> step = solve_linear(std::move(damped), e.right);
    if (step.empty()) break;
    std::vector<double> trial = fit.parameters;
    for (std::size_t a = 0; a < m; ++a) trial[a] += step[a];
    NormalEquations next = linearise(x, y, model, trial);
    if (next.residual < e.residual) {
      fit.parameters = std::move(trial);
      e = std::move(next);
      lambda = std::max(lambda * 0.1, 1e-12);
    } else {
      lambda *= 10;
    }
    fit.converged = left_to_gain(e) <= 1e-12 * e.residual + 1e-28 * size || lambda > 1e12;
  }
  fit.residual = e.residual;
  fit.errors = standard_errors(e, x.size());
  return fit;
}

Fit least_squares(std::span<const double> x, std::span<const double> y, const Model& model,
                  std::span<const std::vector<double>> starts, int max_iterations) {
  if (starts.empty()) throw data_error("a fit needs a start");
  Fit best;
  for (std::size_t s = 0; s < starts.size(); ++s) {
    Fit fit = least_squares(x, y, model, starts[s], max_iterations);
    fit.converged &= std::all_of(fit.parameters.begin(), fit.parameters.end(), [](double p) { return std::isfinite(p); });
    if (s == 0 || (fit.converged && (!best.converged || fit.residual < best.residual))) best = std::move(fit);
  }
  return best;
}

std::vector<double> propagated_errors(std::span<const double> x, std::span<const double> variance, const Model& model,
                                      std::span<const double> parameters) {
  const std::size_t m = parameters.size();
  std::vector<double> g(m), square(m * m, 0.0), middle(m * m, 0.0);
  for (std::size_t k = 0; k < x.size(); ++k) {
    model(x[k], parameters, g);
    for (std::size_t a = 0; a < m; ++a)
      for (std::size_t b = 0; b < m; ++b) {
        square[a * m + b] += g[a] * g[b];
        middle[a * m + b] += g[a] * g[b] * variance[k];
      }
  }
  std::vector<double> errors;
  for (std::size_t a = 0; a < m; ++a) {
    std::vector<double> unit(m, 0.0);
    unit[a] = 1;
    const std::vector<double> row = solve_linear(square, std::move(unit));
    if (row.empty()) return {};
    double sum = 0;
    for (std::size_t b = 0; b < m; ++b)
      for (std::size_t c = 0; c < m; ++c) sum += row[b] * middle[b * m + c] * row[c];
    errors.push_back(std::sqrt(sum));
  }
  return errors;
}

std::optional<SeparableFit> separable_fit(std::span<const double> x, std::span<const double> y, const Terms& terms,
                                          std::size_t linear, std::span<const double> grid) {
  std::vector<double> g(linear);
  const auto at = [&](double q) {
    std::vector<double> matrix(linear * linear, 0.0), right(linear, 0.0);
    for (std::size_t k = 0; k < x.size(); ++k) {
      terms(x[k], q, g);
      for (std::size_t a = 0; a < linear; ++a) {
        right[a] += g[a] * y[k];
        for (std::size_t b = 0; b < linear; ++b) matrix[a * linear + b] += g[a] * g[b];
      }
    }
    SeparableFit fit{q, solve_linear(std::move(matrix), std::move(right)), std::numeric_limits<double>::infinity()};
    if (fit.linear.empty()) return fit;
    fit.residual = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      terms(x[k], q, g);
      double r = y[k];
      for (std::size_t a = 0; a < linear; ++a) r -= g[a] * fit.linear[a];
      fit.residual += r * r;
    }
    if (!std::isfinite(fit.residual)) fit.residual = std::numeric_limits<double>::infinity();
    return fit;
  };
  const auto narrow = [&](double lo, double hi) {  // golden section
    constexpr double golden = 0.6180339887498949;
    SeparableFit a = at(hi - golden * (hi - lo)), b = at(lo + golden * (hi - lo));
    for (int k = 0; k < 45; ++k) {  // to a part in 4e8 of the bracket; rounding of the residual leaves no more
      if (a.residual <= b.residual) {
        hi = b.q;
        b = std::move(a);
        a = at(hi - golden * (hi - lo));
      } else {
        lo = a.q;
        a = std::move(b);
        b = at(lo + golden * (hi - lo));
      }
    }
    return a.residual <= b.residual ? a : b;
  };
  std::vector<double> residual;
  for (const double q : grid) residual.push_back(at(q).residual);
  std::optional<SeparableFit> best;
  for (std::size_t k = 1; k + 1 < grid.size(); ++k) {
    if (!(residual[k] < residual[k - 1] && residual[k] <= residual[k + 1])) continue;
    SeparableFit fit = narrow(grid[k - 1], grid[k + 1]);
    if (!best || fit.residual < best->residual) best = std::move(fit);
  }
  if (best && (residual.front() < best->residual || residual.back() < best->residual)) best.reset();
  return best;
}

std::vector<double> geometric_grid(double lo, double hi, std::size_t n) {
  std::vector<double> grid;
  for (std::size_t k = 0; k < n; ++k)
    grid.push_back(lo * std::pow(hi / lo, static_cast<double>(k) / static_cast<double>(std::max<std::size_t>(n, 2) - 1)));
  return grid;
}

}  // namespace jam
