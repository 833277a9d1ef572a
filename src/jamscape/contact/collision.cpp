#include "jamscape/contact/collision.hpp"

#include <cmath>
#include <string>

#include "jamscape/base/error.hpp"
#include "jamscape/contact/law.hpp"

namespace jam {
namespace {

struct State {
  double x, v;
};

/// Where |dashpot| = |spring| at speed v: x^(delta - nu) = g |v|.
double balance(NormalLaw law, double g_v) { return law == NormalLaw::tsuji ? std::pow(g_v, 0.8) : g_v; }

template <NormalLaw law>
double integrate(DampingRule rule, double g) {
  constexpr double h = 2e-4;
  const auto acceleration = [g](State s) {
    const double x = s.x > 0 ? s.x : 0, root = shape<law>(x);
    const double dashpot = law == NormalLaw::tsuji ? g * s.v * square_root(root) : g * s.v * root;
    return -(root * x + dashpot);
  };
  State s{rule == DampingRule::printed ? balance(law, g) : 0.0, 1.0};
  while (true) {
    const State a{s.v, acceleration(s)};
    const State at_b{s.x + h / 2 * a.x, s.v + h / 2 * a.v}, b{at_b.v, acceleration(at_b)};
    const State at_c{s.x + h / 2 * b.x, s.v + h / 2 * b.v}, c{at_c.v, acceleration(at_c)};
    const State at_d{s.x + h * c.x, s.v + h * c.v}, d{at_d.v, acceleration(at_d)};
    const State next{s.x + h / 6 * (a.x + 2 * b.x + 2 * c.x + d.x), s.v + h / 6 * (a.v + 2 * b.v + 2 * c.v + d.v)};
    // How far the grains are from flying free: the spring's lead over the dashpot, or the overlap itself.
    const auto lead = [&](State at) { return rule == DampingRule::unclipped ? at.x : at.x - balance(law, -g * at.v); };
    if (next.v < 0 && !(lead(next) > 0)) {
      const double from = lead(s), to = lead(next), part = s.v < 0 && from > to ? from / (from - to) : 1.0;
      return -(s.v + part * (next.v - s.v));
    }
    s = next;
  }
}

}  // namespace

double collision_restitution(NormalLaw law, DampingRule rule, double g) {
  return with_law(law, [&]<NormalLaw kind>() { return integrate<kind>(rule, g); });
}

double collision_damping(NormalLaw law, DampingRule rule, double e) {
  if (e >= 1) return 0;
  // The restitution falls with g until the printed rule turns it up again: step to where it is small enough, then
  // halve.
  constexpr double stride = 0.02, farthest = 40;
  double lo = 0, hi = 0, lowest = 1;
  while (true) {
    const double next = hi < 2 ? hi + stride : 1.05 * hi, there = collision_restitution(law, rule, next);
    if (there <= e) {
      lo = hi, hi = next;
      break;
    }
    if (there > lowest || next > farthest)
      throw usage_error("contact.restitution: this law and damping rule cannot reach a restitution of " +
                            std::to_string(e) + " (smallest: " + std::to_string(lowest) + ")",
                        {}, "contact.damping = \"clipped\", or a larger restitution");
    lowest = there, hi = next;
  }
  for (int k = 0; k < 48; ++k) {
    const double mid = (lo + hi) / 2;
    (collision_restitution(law, rule, mid) > e ? lo : hi) = mid;
  }
  return hi;
}

}  // namespace jam
