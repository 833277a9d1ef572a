#include "jamscape/contact/time_scale.hpp"

#include <cmath>
#include <numbers>

namespace jam {

double collision_prefactor(double beta) {
  return std::sqrt(std::numbers::pi) * std::tgamma(1 / (2 + beta)) /
         ((1 + beta / 2) * std::tgamma((4 + beta) / (4 + 2 * beta)));
}

double collision_time(double mbar, double k_n, double speed, double beta) {
  const double power = 1 / (2 + beta);
  const double impact = beta == 0 ? 1 : std::pow(speed, -beta * power);
  return collision_prefactor(beta) * std::pow((1 + beta / 2) * mbar / k_n, power) * impact;
}

double material_stiffness(double young, double poisson, double diameter, double beta) {
  return 2 * young * std::pow(diameter, 1 - beta) / (3 * (1 - poisson * poisson));
}

}  // namespace jam
