// Units: values written as text, "2.5e-5 d/tau_c" or "0.01 cm/s", and what turns SI into scaled units.
//
// A unit is a product of names with exponents: "d/tau_c", "m/(d^0.5 tau_c^2)", "N/m^1.5". Scaled units are made of
//   d (mean diameter), m (mean mass), tau_c (collision time);
// SI units of m, cm, mm, um, km, kg, g, mg, s, ms, us, min, h, N, mN, uN, kN, Pa, kPa, MPa, GPa, J, mJ, uJ, Hz, rad.
// What stands in a study file is tried as a scaled unit first; "m" is a mass there only where a mass is expected.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "jamscape/base/option.hpp"

namespace jam {

/// Exponents of length, mass and time.
struct Dimensions {
  double length = 0, mass = 0, time = 0;
};
bool same(const Dimensions& a, const Dimensions& b);

/// A unit is over/under times the product of m, kg and s with these exponents (two numbers, so that "1.735 cm" becomes
/// the double nearest to 0.01735).
struct Unit {
  Dimensions dimensions;
  double over = 1, under = 1;
};

/// Nothing where the text is no such unit; an empty text is the unit of a bare number.
std::optional<Dimensions> read_scaled_unit(std::string_view text);
std::optional<Unit> read_si_unit(std::string_view text);

/// The SI unit of these dimensions, "m/s" or "kg/(m^0.5 s^2)".
std::string si_unit(const Dimensions& dimensions);

/// d, m and tau_c of a study in m, kg and s; all 0 in a study that is in scaled units only.
struct Scales {
  double length = 0, mass = 0, time = 0;

  bool known() const { return length > 0; }
  /// One scaled unit of these dimensions, in SI.
  double of(const Dimensions& dimensions) const;
};

/// `value` in SI units as a scaled number, rounded to 12 digits: tasks are named by these numbers, and the last digits
/// hang on the machine's library.
double to_scaled(double value, const Dimensions& dimensions, const Scales& scales);

/// The number in the option's own unit (meta.unit). Throws a usage error for text that is no number, a missing or
/// unknown unit, a unit of something else, and for SI units where `scales` are not known.
double read_quantity(std::string_view text, std::string_view key, const OptionMeta& meta, const std::string& place,
                     const Scales& scales = {});

}  // namespace jam
