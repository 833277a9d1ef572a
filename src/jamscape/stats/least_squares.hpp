// Unweighted non-linear least squares for a handful of parameters, by Levenberg-Marquardt with Marquardt's scaling:
//
//   (J^T J + lambda diag(J^T J)) step = J^T (y - model)
//
// Source: Marquardt, J. SIAM 11, 431 (1963).
#pragma once

#include <functional>
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

/// Solves the n x n system a x = b (row-major) by elimination with partial pivoting; empty when a is singular.
std::vector<double> solve_linear(std::vector<double> a, std::vector<double> b);

}  // namespace jam
