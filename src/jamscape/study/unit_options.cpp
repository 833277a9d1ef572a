#include "jamscape/study/unit_options.hpp"

#include <fmt/format.h>

#include "jamscape/base/error.hpp"
#include "jamscape/contact/time_scale.hpp"

namespace jam {
namespace {

using Places = std::map<std::string, std::string>;

double stiffness(const UnitOptions& u, NormalLaw law) {
  return material_stiffness(u.young, u.poisson, u.length, hardening_exponent(law));
}

/// Where [units] begins.
std::string place_of_units(const Places& places) {
  for (const auto& [key, place] : places)
    if (key.starts_with("units.")) return place;
  return {};
}

}  // namespace

Scales scales_of(const UnitOptions& u, NormalLaw law, const Places& places) {
  const std::string place = place_of_units(places);
  if (place.empty()) return {};
  const auto need = [&](bool there, const char* key, const char* example) {
    if (!there)
      throw usage_error(fmt::format("the group [units] has no '{}', so SI units cannot be converted", key), place,
                        fmt::format("{} = \"{}\" below [units]", key, example));
  };
  need(u.length > 0, "length", "1.735 cm");
  need(u.mass > 0, "mass", "3.0 g");
  if (u.time > 0) return {u.length, u.mass, u.time};
  const double beta = hardening_exponent(law);
  need(u.young > 0, "young", "23.45 kPa");
  need(beta == 0 || u.speed > 0, "speed", "0.01 cm/s");
  const double mbar = u.reduced_mass == ReducedMass::half ? u.mass / 2 : u.mass;
  return {u.length, u.mass, collision_time(mbar, stiffness(u, law), u.speed, beta)};
}

void set_material(const UnitOptions& u, const Scales& scales, ContactOptions& contact, const Places& places) {
  if (!scales.known()) return;
  const double beta = hardening_exponent(contact.law);
  if (u.young > 0 && !places.contains("contact.stiffness"))
    contact.stiffness = to_scaled(stiffness(u, contact.law), {-beta, 1, -2}, scales);
  if (u.speed > 0 && !places.contains("contact.impact_speed"))
    contact.impact_speed = to_scaled(u.speed, {1, 0, -1}, scales);
}

std::string describe_scales(const Scales& scales) {
  return fmt::format("d = {:.6g} m, m = {:.6g} kg, tau_c = {:.6g} s", scales.length, scales.mass, scales.time);
}

}  // namespace jam
