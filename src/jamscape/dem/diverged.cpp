#include "jamscape/dem/diverged.hpp"

#include <fmt/format.h>

#include <cmath>

#include "jamscape/contact/time_scale.hpp"

namespace jam {

Diverged diverged_at(std::int64_t step, const std::string& body, std::span<const double> place,
                     const std::string& problem, const std::string& cause) {
  std::string at;
  for (const double x : place) at += (at.empty() ? "" : ", ") + std::to_string(x);
  return Diverged(fmt::format("step {}: {} at ({}) {}; likely {}", step, body, at, problem, cause));
}

std::string beyond_plane(double beyond, bool high, int axis, double position) {
  return fmt::format("{:.3g} beyond the {} wall at {} = {:.6g}", beyond, high ? "upper" : "lower", "xyz"[axis],
                     position);
}

std::size_t find_not_finite(const double* rows, std::size_t count, std::size_t stride) {
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t c = 0; c < stride; ++c)
      if (!std::isfinite(rows[k * stride + c])) return k;
  return count;
}

std::string step_too_long(double dt, double lightest, double k_n, const char* bodies) {
  constexpr double steps_needed = 8, steps_advised = 40;  // that a contact lasts
  const double lasts = collision_time(lightest / 2, k_n, 1, 0);
  if (!(lasts < steps_needed * dt)) return {};
  return fmt::format(
      "the time step {:.3g} is too long for the stiffness: a contact of the lightest {} lasts {:.2g}; {:.2g} would do",
      dt, bodies, lasts, lasts / steps_advised);
}

}  // namespace jam
