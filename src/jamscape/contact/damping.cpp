#include "jamscape/contact/damping.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

// Head-on collision in scaled time (w0 = 1, impact speed 1): x'' + 2 z x' + x = 0. The printed rule has no force while
// |2 z x'| > |x|: the grains fly freely from (0, 1) to (2 z, 1), and again from where 2 z |x'| = x on the way out.
double printed_restitution(double z) {
  double x = 2 * z, v = 1;
  const double h = 1e-4;
  auto acceleration = [z](double px, double pv) { return -px - 2 * z * pv; };
  for (int k = 0; k < 10'000'000; ++k) {
    const double k1x = v, k1v = acceleration(x, v);
    const double k2x = v + h / 2 * k1v, k2v = acceleration(x + h / 2 * k1x, v + h / 2 * k1v);
    const double k3x = v + h / 2 * k2v, k3v = acceleration(x + h / 2 * k2x, v + h / 2 * k2v);
    const double k4x = v + h * k3v, k4v = acceleration(x + h * k3x, v + h * k3v);
    x += h / 6 * (k1x + 2 * k2x + 2 * k3x + k4x);
    v += h / 6 * (k1v + 2 * k2v + 2 * k3v + k4v);
    if (v < 0 && -2 * z * v >= x) break;
  }
  return -v;
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
      return printed_restitution(z);
  }
  return 0;
}

double solve_damping(double k_n, double mbar, double restitution, DampingRule rule) {
  const double w0 = std::sqrt(k_n / mbar);
  if (restitution >= 1) return 0;
  if (rule == DampingRule::unclipped) {
    const double l = -std::log(restitution);
    return 2 * w0 * l / std::hypot(std::numbers::pi, l);
  }
  double lo = 0, hi = 0.999999;
  if (rule == DampingRule::printed) {  // not monotonic: search up to its minimum only
    double best = 1, z_best = 0;
    for (double z = 0.01; z < 1; z += 0.01)
      if (const double e = linear_restitution(z, rule); e < best) best = e, z_best = z;
    if (restitution < best)
      throw usage_error("contact.restitution: the printed damping rule cannot reach a restitution of " +
                            std::to_string(restitution) + " (smallest: " + std::to_string(best) + ")",
                        {}, "contact.damping = \"clipped\", or a larger restitution");
    hi = z_best;
  }
  for (int k = 0; k < 100; ++k) {
    const double mid = (lo + hi) / 2;
    (linear_restitution(mid, rule) > restitution ? lo : hi) = mid;
  }
  return 2 * w0 * lo;
}

namespace {

PairLaw<> law_with(const ContactOptions& o, double mass, double mu) {
  if (o.law != NormalLaw::linear)
    throw usage_error("contact.law: the damping of the Hertz law is not solved for a restitution yet", {},
                      "contact.law = \"linear\"");
  PairLaw<> law{};
  law.k_n = o.stiffness;
  law.gamma_n = solve_damping(o.stiffness, mass / 2, o.restitution, o.damping);
  law.k_t = o.tangential_stiffness * o.stiffness;
  law.gamma_t = o.tangential_damping * law.gamma_n;
  law.inverse_k_t = law.k_t > 0 ? 1 / law.k_t : 0;
  law.mu = mu;
  law.lever_cut = o.lever == LeverArm::contact_point ? 0.5 : 0.0;
  law.floor = o.damping == DampingRule::clipped ? 0.0 : -std::numeric_limits<double>::infinity();
  law.damping_limit = o.damping == DampingRule::printed ? 1.0 : std::numeric_limits<double>::infinity();
  return law;
}

}  // namespace

PairLaw<> grain_law(const ContactOptions& o, double mass) { return law_with(o, mass, o.friction); }

PairLaw<> wall_law(const ContactOptions& o, double mass) {
  return law_with(o, mass, o.wall_friction < 0 ? o.friction : o.wall_friction);
}

}  // namespace jam
