#include "jamscape/contact/damping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "jamscape/base/error.hpp"
#include "jamscape/contact/collision.hpp"

namespace jam {
namespace {

/// gamma_n of the unclipped linear law, in closed form.
double linear_damping(double k_n, double mbar, double restitution) {
  const double w0 = std::sqrt(k_n / mbar), l = -std::log(restitution);
  return 2 * w0 * l / std::hypot(std::numbers::pi, l);
}

/// gamma_n of the clipped linear law: bisects the closed form of the restitution.
double clipped_damping(double k_n, double mbar, double restitution) {
  double lo = 0, hi = 0.999999;
  for (int k = 0; k < 100; ++k) {
    const double mid = (lo + hi) / 2;
    (linear_restitution(mid, DampingRule::clipped) > restitution ? lo : hi) = mid;
  }
  return 2 * std::sqrt(k_n / mbar) * lo;
}

/// The dashpot of reduced mass mbar at spring k_n: from the damping ratio where it is given, else from the restitution.
double damping(const ContactOptions& o, double k_n, double mbar, double restitution) {
  if (o.damping_ratio < 0) return solve_damping(o.law, o.damping, k_n, mbar, restitution, o.impact_speed);
  if (hertzian(o.law))
    throw usage_error("contact.damping_ratio: a Hertz law has no constant damping ratio", {},
                      "contact.restitution, or contact.law = \"linear\" or \"ratio\"");
  return 2 * o.damping_ratio * std::sqrt(o.law == NormalLaw::ratio ? k_n : k_n / mbar);
}

PairLaw<> law_with(const ContactOptions& o, double k_n, double gamma_n, double mu) {
  PairLaw<> law{};
  law.k_n = k_n;
  law.gamma_n = gamma_n;
  law.k_t = o.tangential_stiffness * k_n;
  law.gamma_t = o.tangential_damping * gamma_n;
  if (o.law == NormalLaw::ratio) law.gamma_t *= std::sqrt(o.tangential_stiffness);
  law.inverse_k_t = law.k_t > 0 ? 1 / law.k_t : 0;
  law.mu = mu;
  law.lever_cut = o.lever == LeverArm::contact_point ? 0.5 : 0.0;
  law.floor = o.damping == DampingRule::clipped ? 0.0 : -std::numeric_limits<double>::infinity();
  law.printed = o.damping == DampingRule::printed;
  law.springless = law.k_t == 0;
  return law;
}

}  // namespace

double linear_restitution(double z, DampingRule rule) {
  const double w = std::sqrt(1 - z * z);
  switch (rule) {
    case DampingRule::unclipped:
      return std::exp(-std::numbers::pi * z / w);
    case DampingRule::clipped:  // the force vanishes where x = -2 z x'
      return std::exp(-(z / w) * (std::numbers::pi - std::atan2(2 * z * w, 1 - 2 * z * z)));
    case DampingRule::printed:
      break;
  }
  return collision_restitution(NormalLaw::linear, rule, 2 * z);
}

double solve_damping(NormalLaw law, DampingRule rule, double k_n, double mbar, double restitution, double speed) {
  if (restitution >= 1) return 0;
  if (law == NormalLaw::ratio)
    return std::sqrt(mbar) * solve_damping(NormalLaw::linear, rule, k_n, mbar, restitution, speed);
  if (law == NormalLaw::linear && rule == DampingRule::unclipped) return linear_damping(k_n, mbar, restitution);
  if (law == NormalLaw::linear && rule == DampingRule::clipped) return clipped_damping(k_n, mbar, restitution);
  const double g = collision_damping(law, rule, restitution);
  if (law == NormalLaw::linear) return g * std::sqrt(k_n / mbar);
  const double nu = law == NormalLaw::hertz ? 0.5 : 0.25, depth = std::pow(mbar * speed * speed / k_n, 0.4);
  return g * speed / std::pow(depth, 1 + nu);
}

PairLaw<> grain_law(const ContactOptions& o, double mass) {
  return law_with(o, o.stiffness, damping(o, o.stiffness, mass / 2, o.restitution), o.friction);
}

PairLaw<> wall_law(const ContactOptions& o, double mass) {
  const double k_n = o.wall_stiffness * o.stiffness;
  const double gamma_n =
      o.wall_restitution < 0
          ? damping(o, o.law == NormalLaw::ratio ? k_n : o.stiffness, mass / 2, o.restitution)
          : solve_damping(o.law, o.damping, k_n, mass, std::max(o.wall_restitution, 0.01), o.impact_speed);
  return law_with(o, k_n, gamma_n, o.wall_friction < 0 ? o.friction : o.wall_friction);
}

}  // namespace jam
