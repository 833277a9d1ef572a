// Options of the contact laws, and what the laws are made of (theory sec. 2.1-2.3).
#pragma once

#include <numbers>
#include <string_view>
#include <utility>

#include "jamscape/base/option.hpp"

namespace jam {

/// Exponents of spring and dashpot: k_n x^delta - gamma_n x^nu mbar v_n (theory sec. 2.2).
enum class NormalLaw {
  linear,  ///< delta = 1, nu = 0
  hertz,   ///< delta = 3/2, nu = 1/2: viscoelastic spheres; the restitution falls with the impact speed
  tsuji,   ///< delta = 3/2, nu = 1/4: Hertz with a restitution that does not depend on the impact speed
  ratio    ///< delta = 1, nu = 0, the dashpot gamma_n sqrt(mbar): one damping ratio, hence one restitution, for all
           ///< masses; the Coulomb limit is mu times the spring alone [S3 Eq. 3, 5]
};
/// Whether spring and dashpots carry the factor s(x) = x^(1/2).
constexpr bool hertzian(NormalLaw law) { return law == NormalLaw::hertz || law == NormalLaw::tsuji; }

template <>
struct EnumNames<NormalLaw> {
  static constexpr std::pair<NormalLaw, std::string_view> values[] = {{NormalLaw::linear, "linear"},
                                                                      {NormalLaw::hertz, "hertz"},
                                                                      {NormalLaw::tsuji, "tsuji"},
                                                                      {NormalLaw::ratio, "ratio"}};
};

/// What happens when the dashpot would make the normal force attractive: nothing (S1), the force is cut at zero, or
/// the rule printed in S2 Eq. 1 (force zero whenever |dashpot| > |spring|, on approach too).
enum class DampingRule { unclipped, clipped, printed };
template <>
struct EnumNames<DampingRule> {
  static constexpr std::pair<DampingRule, std::string_view> values[] = {
      {DampingRule::unclipped, "unclipped"}, {DampingRule::clipped, "clipped"}, {DampingRule::printed, "printed"}};
};

/// Lever arm of the tangential force: the radius R, or the distance R - x/2 to the contact point.
enum class LeverArm { radius, contact_point };
template <>
struct EnumNames<LeverArm> {
  static constexpr std::pair<LeverArm, std::string_view> values[] = {{LeverArm::radius, "radius"},
                                                                     {LeverArm::contact_point, "contact_point"}};
};

/// What a tangential spring of spheres does when the pair turns about its own normal: nothing, it is only projected
/// onto the tangential plane (S1, S2, LAMMPS); or it turns along with the mean spin of the two about the normal.
enum class SpringTurn { projected, twirled };
template <>
struct EnumNames<SpringTurn> {
  static constexpr std::pair<SpringTurn, std::string_view> values[] = {{SpringTurn::projected, "projected"},
                                                                       {SpringTurn::twirled, "twirled"}};
};

struct ContactOptions {
  NormalLaw law = NormalLaw::linear;
  double stiffness = std::numbers::pi * std::numbers::pi / 2;
  double restitution = 0.5;
  double damping_ratio = -1;
  double friction = 0.5;
  double tangential_stiffness = 0.8;
  double tangential_damping = 1.0;
  DampingRule damping = DampingRule::unclipped;
  LeverArm lever = LeverArm::radius;
  SpringTurn spring_turn = SpringTurn::projected;
  double impact_speed = 1;
  double wall_friction = -1;
  double wall_stiffness = 1;
  double wall_restitution = -1;

  template <class V>
  void describe(V& v) {
    v.option("law", law,
             {.text = "normal force law: linear, hertz (spring x^3/2, dashpot x^1/2), tsuji (x^3/2, x^1/4), or ratio "
                      "(linear, one damping ratio for all masses, Coulomb limit on the spring alone)",
              .source = "S1 App. A; S2 Eq. 1; S3 Eq. 3, 5"});
    v.option("stiffness", stiffness,
             {.text = "normal spring k_n (per d^1/2 for the Hertz laws); linear: pi^2/2 is tau_c = half the undamped "
                      "period",
              .unit = "m/tau_c^2",
              .min = 0,
              .above_min = true,
              .source = "theory 2.1"});
    v.option(
        "restitution", restitution,
        {.text = "normal restitution of two mean grains; the damping is solved for it unless damping_ratio is given",
         .min = 0.01,
         .max = 1,
         .source = "S1 App. A"});
    v.option("damping_ratio", damping_ratio,
             {.text = "laws linear and ratio: the normal dashpot over the critical one, of two mean grains; -1: solved "
                      "for the restitution",
              .min = -1,
              .max = 1,
              .source = "S3 Eq. 7"});
    v.option("impact_speed", impact_speed,
             {.text = "speed of the impact that has this restitution; matters to the hertz law only",
              .unit = "d/tau_c",
              .min = 0,
              .max = 1e6,
              .above_min = true,
              .source = "theory 2.2"});
    v.option("friction", friction, {.text = "Coulomb coefficient mu between grains", .min = 0, .max = 1e6});
    v.option("tangential_stiffness", tangential_stiffness,
             {.text = "tangential over normal stiffness k_t/k_n", .min = 0, .max = 10});
    v.option("tangential_damping", tangential_damping,
             {.text = "tangential over normal damping gamma_t/gamma_n; law ratio: of the damping ratios",
              .min = 0,
              .max = 10});
    v.option("damping", damping, {.text = "rule for a dashpot stronger than the spring", .source = "theory 2.1, 2.2"});
    v.option("lever", lever, {.text = "lever arm of the tangential force", .source = "theory 2.3"});
    v.option("spring_turn", spring_turn,
             {.text = "spheres: tangential springs are projected onto the tangential plane, or also twirled with pairs "
                      "that turn about their own normal",
              .source = "theory 2.3"});
    v.option("wall_friction", wall_friction,
             {.text = "Coulomb coefficient between grains and walls; -1: as between grains", .min = -1, .max = 1e6});
    v.option("wall_stiffness", wall_stiffness,
             {.text = "springs between grains and walls over those between grains; 2.828 is a rigid wall for Hertz",
              .min = 1e-6,
              .max = 1e6,
              .source = "theory 1, note d"});
    v.option("wall_restitution", wall_restitution,
             {.text = "restitution of a mean grain at a wall; -1: the dashpots are those between grains",
              .min = -1,
              .max = 1});
  }
};

}  // namespace jam
