#include "jamscape/stats/least_squares.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

double exponential(double x, std::span<const double> p, std::span<double> g) {
  const double e = std::exp(-p[1] * x);
  g[0] = e;
  g[1] = -p[0] * x * e;
  return p[0] * e;
}

TEST(LeastSquares, FindsAnExactModel) {
  std::vector<double> x, y;
  for (int k = 0; k < 30; ++k) {
    x.push_back(0.1 * k);
    y.push_back(3 * std::exp(-1.3 * x.back()));
  }
  const Fit fit = least_squares(x, y, exponential, {1, 0.2});
  EXPECT_TRUE(fit.converged);
  EXPECT_NEAR(fit.parameters[0], 3, 1e-8);
  EXPECT_NEAR(fit.parameters[1], 1.3, 1e-8);
  EXPECT_LT(fit.residual, 1e-15);
}

TEST(LeastSquares, LineErrorsAreTheTextbookOnes) {
  const std::vector<double> x = {0, 1, 2, 3}, y = {0.1, 0.9, 2.2, 2.8};
  const Model line = [](double t, std::span<const double> p, std::span<double> g) {
    g[0] = 1;
    g[1] = t;
    return p[0] + p[1] * t;
  };
  const Fit fit = least_squares(x, y, line, {0, 0});
  // slope = Sxy/Sxx = 4.7/5, residual/(n - 2) = .082/2, error^2 = .041/Sxx
  EXPECT_NEAR(fit.parameters[1], 0.94, 1e-8);
  EXPECT_NEAR(fit.parameters[0], 0.09, 1e-8);
  EXPECT_NEAR(fit.errors[1], std::sqrt(fit.residual / 2 / 5), 1e-10);
  EXPECT_NEAR(fit.residual, 0.082, 1e-10);
}

TEST(LeastSquares, RefusesTooFewPoints) {
  const std::vector<double> x = {0}, y = {1};
  EXPECT_THROW(least_squares(x, y, exponential, {1, 1}), Error);
}

TEST(SolveLinear, PivotsAndNoticesSingularity) {
  EXPECT_EQ(solve_linear({0, 2, 1, 0}, {4, 3}), (std::vector<double>{3, 2}));
  EXPECT_TRUE(solve_linear({1, 2, 2, 4}, {1, 2}).empty());
}

}  // namespace
}  // namespace jam
