// Unweighted non-linear least squares for a handful of parameters, by Levenberg-Marquardt with Marquardt's scaling:
//
//   (J^T J + lambda diag(J^T J)) step = J^T (y - model)
//
// Source: Marquardt, J. SIAM 11, 431 (1963).
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace jam {

/// The model's value at x; writes its derivatives by the parameters to `gradient`.
using Model = std::function<double(double x, std::span<const double> parameters, std::span<double> gradient)>;

struct Fit {
  std::vector<double> parameters;
  std::vector<double> errors;  ///< standard errors from the residuals; NaN without degrees of freedom
  double residual = 0;         ///< sum of the squared residuals
  int iterations = 0;
  bool converged = false;  ///< no step is left that would take more than a part in 1e12 off the residual
};

/// Throws a data error when x and y differ in length or there are fewer points than parameters.
Fit least_squares(std::span<const double> x, std::span<const double> y, const Model& model, std::vector<double> start,
                  int max_iterations = 200);

/// The fit of lowest residual among those from several starts that converged; the one from the first start where none
/// did. Errors as above.
Fit least_squares(std::span<const double> x, std::span<const double> y, const Model& model,
                  std::span<const std::vector<double>> starts, int max_iterations = 200);

/// Standard errors of parameters fitted without weights to ordinates that have these variances and are independent:
/// the diagonal of H J^T diag(variance) J H with H = (J^T J)^-1. Unlike errors from the residuals they do not grow with
/// the misfit of a law that is not quite that of the data. Empty where the equations are singular.
std::vector<double> propagated_errors(std::span<const double> x, std::span<const double> variance, const Model& model,
                                      std::span<const double> parameters);

/// Of a model that is linear in all parameters but one, q. `terms` writes the factors of the linear parameters at x.
struct SeparableFit {
  double q = 0;
  std::vector<double> linear;
  double residual = 0;
};
using Terms = std::function<void(double x, double q, std::span<double> factors)>;

/// The least squares of such a model without a start: at each q the best linear parameters are solved for, the residual
/// that is left is taken on an increasing grid of q, and each of its minima narrowed down. Empty where the residual is
/// lowest at an end of the grid: there is no fit inside it.
std::optional<SeparableFit> separable_fit(std::span<const double> x, std::span<const double> y, const Terms& terms,
                                          std::size_t linear, std::span<const double> grid);

/// n values from lo to hi in equal ratios.
std::vector<double> geometric_grid(double lo, double hi, std::size_t n);

/// Solves the n x n system a x = b (row-major) by elimination with partial pivoting; empty when a is singular.
std::vector<double> solve_linear(std::vector<double> a, std::vector<double> b);

}  // namespace jam
