// [units]: what d, m and tau_c are in SI, so that options may be written with SI units (base/units.hpp).
//
//   [units]
//   length = "1.735 cm"     # d
//   mass = "3.0 g"          # m
//   young = "23.45 kPa"     # tau_c is the collision time of S2 Eq. 4 (contact/time_scale.hpp) ...
//   poisson = 0.5
//   speed = "0.01 cm/s"     # ... at this speed; or time = "6.4 ms" says tau_c itself
//
// contact.stiffness follows from young and poisson, and contact.impact_speed from speed, unless a study sets them.
// Everything else in a study, and all results, are in scaled units.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "jamscape/base/option.hpp"
#include "jamscape/base/schema.hpp"
#include "jamscape/base/units.hpp"
#include "jamscape/contact/options.hpp"

namespace jam {

/// Which mass stands in the collision time: that of two mean grains meeting (m/2), or the mean mass m, as S2's text
/// calls it (theory sec. 2.2).
enum class ReducedMass { half, mean };
template <>
struct EnumNames<ReducedMass> {
  static constexpr std::pair<ReducedMass, std::string_view> values[] = {{ReducedMass::half, "half"},
                                                                        {ReducedMass::mean, "mean"}};
};

struct UnitOptions {
  double length = 0, mass = 0, time = 0;
  double young = 0, poisson = 0.5, speed = 0;
  ReducedMass reduced_mass = ReducedMass::half;

  template <class V>
  void describe(V& v) {
    v.option("length", length,
             {.text = "the mean diameter d, for example \"1.735 cm\"", .unit = "m", .min = 0, .si = true});
    v.option("mass", mass, {.text = "the mean mass m of a grain", .unit = "kg", .min = 0, .si = true});
    v.option("time", time,
             {.text = "the unit of time tau_c; 0: the collision time, from young, poisson and speed",
              .unit = "s",
              .min = 0,
              .si = true});
    v.option(
        "young", young,
        {.text = "Young's modulus Y of the grains; 0: none", .unit = "Pa", .min = 0, .si = true, .source = "S2 Eq. 1"});
    v.option("poisson", poisson,
             {.text = "Poisson's ratio of the grains", .min = -1, .max = 0.5, .source = "S2 Eq. 1"});
    v.option(
        "speed", speed,
        {.text = "speed v0 of the impact that lasts tau_c", .unit = "m/s", .min = 0, .si = true, .source = "S2 Eq. 4"});
    v.option("reduced_mass", reduced_mass,
             {.text = "mass in the collision time: half the mean mass (two mean grains), or the mean mass",
              .source = "theory 2.2"});
  }
};

/// All 0 where no unit was given. Throws a usage error where some are missing; `places` says where keys were written.
Scales scales_of(const UnitOptions& units, NormalLaw law, const std::map<std::string, std::string>& places);

/// contact.stiffness and contact.impact_speed as the material and the speed give them, in scaled units, unless they
/// have a place of their own.
void set_material(const UnitOptions& units, const Scales& scales, ContactOptions& contact,
                  const std::map<std::string, std::string>& places);

/// "d = 0.01735 m, m = 0.003 kg, tau_c = 0.0063984 s"
std::string describe_scales(const Scales& scales);

}  // namespace jam
