#include "jamscape/stats/force_laws.hpp"

#include <cmath>
#include <vector>

#include "jamscape/base/border.hpp"
#include "jamscape/stats/least_squares.hpp"
#include "jamscape/stats/none.hpp"

namespace jam {
namespace {

bool has_density(std::span<const double> density) {
  double sum = 0;
  for (const double p : density) sum += p;
  return sum > 0;
}

}  // namespace

double density(const MuethLaw& law, double f) {
  return law.a * (1 - law.b * std::exp(-f * f)) * std::exp(-law.beta * f);
}

double density(const GaussianLaw& law, double f) {
  const double u = (f - law.centre) / law.width;
  return law.height * std::exp(-0.5 * u * u);
}

// Fitted as A exp(-beta f) - B exp(-f^2 - beta f), linear in A and B = A b.
MuethLaw fit_mueth(std::span<const double> centre, std::span<const double> density) {
  if (centre.size() < 4 || !has_density(density)) return {none, none, none};
  const Terms terms = [](double f, double beta, std::span<double> factors) {
    factors[0] = std::exp(-beta * f);
    factors[1] = -std::exp(-f * f - beta * f);
  };
  const auto fit = separable_fit(centre, density, terms, 2, geometric_grid(0.02, 50, 60));
  if (!fit || fit->linear[0] == 0) return {none, none, none};
  return {fit->linear[0], fit->linear[1] / fit->linear[0], fit->q};
}

GaussianLaw fit_gaussian(std::span<const double> centre, std::span<const double> density) {
  if (centre.size() < 4 || !has_density(density)) return {none, none, none};
  double sum = 0, mean = 0, square = 0, highest = 0, peak = 0;
  for (std::size_t k = 0; k < centre.size(); ++k) {
    sum += density[k];
    mean += density[k] * centre[k];
    square += density[k] * centre[k] * centre[k];
    if (exceeds(density[k], highest)) highest = density[k], peak = centre[k];
  }
  mean /= sum;
  const double variance = square / sum - mean * mean;
  if (!(variance > 0)) return {none, none, none};
  const Model model = [](double f, std::span<const double> p, std::span<double> gradient) {
    const double u = (f - p[1]) / p[2], e = std::exp(-0.5 * u * u);
    gradient[0] = e;
    gradient[1] = p[0] * e * u / p[2];
    gradient[2] = p[0] * e * u * u / p[2];
    return p[0] * e;
  };
  const double sd = std::sqrt(variance);
  const std::vector<double> starts[] = {{highest, mean, sd},     {highest, peak, sd},    {highest, peak, sd / 3},
                                        {highest, mean, 2 * sd}, {highest, 0, sd},       {highest, -mean, 2 * sd}};
  const Fit fit = least_squares(centre, density, model, starts, 2000);
  if (!fit.converged) return {none, none, none};
  return {fit.parameters[0], fit.parameters[1], std::abs(fit.parameters[2])};
}

}  // namespace jam
