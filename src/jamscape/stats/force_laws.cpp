#include "jamscape/stats/force_laws.hpp"

#include <cmath>
#include <limits>

#include "jamscape/stats/least_squares.hpp"

namespace jam {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

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

MuethLaw fit_mueth(std::span<const double> centre, std::span<const double> density) {
  if (centre.size() < 4 || !has_density(density)) return {none, none, none};
  const Model model = [](double f, std::span<const double> p, std::span<double> gradient) {
    const double bell = std::exp(-f * f), fall = std::exp(-p[2] * f), rise = 1 - p[1] * bell;
    gradient[0] = rise * fall;
    gradient[1] = -p[0] * bell * fall;
    gradient[2] = -f * p[0] * rise * fall;
    return p[0] * rise * fall;
  };
  const Fit fit = least_squares(centre, density, model, {3, 0.75, 1.5});
  if (!fit.converged) return {none, none, none};
  return {fit.parameters[0], fit.parameters[1], fit.parameters[2]};
}

GaussianLaw fit_gaussian(std::span<const double> centre, std::span<const double> density) {
  if (centre.size() < 4 || !has_density(density)) return {none, none, none};
  double sum = 0, mean = 0, square = 0, highest = 0;
  for (std::size_t k = 0; k < centre.size(); ++k) {
    sum += density[k];
    mean += density[k] * centre[k];
    square += density[k] * centre[k] * centre[k];
    highest = std::max(highest, density[k]);
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
  const Fit fit = least_squares(centre, density, model, {highest, mean, std::sqrt(variance)});
  if (!fit.converged) return {none, none, none};
  return {fit.parameters[0], fit.parameters[1], std::abs(fit.parameters[2])};
}

}  // namespace jam
