// The error of a simulation that is no longer sound, and what both engines say in it.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

namespace jam {

/// An overlap beyond a radius, a grain outside its box, or a position that is not a number. what() names the step, the
/// grain, its place, and the likely cause.
class Diverged : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// "step 7: grain 3 at (1, 2) is outside ...; likely ..."
Diverged diverged_at(std::int64_t step, const std::string& body, std::span<const double> place,
                     const std::string& problem, const std::string& cause);

/// "0.2 beyond the upper wall at y = 3", for a plane across `axis`.
std::string beyond_plane(double beyond, bool high, int axis, double position);

inline constexpr const char* not_a_number = "has a position or velocity that is not a number";
/// Index of the first of `count` rows with such a number in it, `count` if there is none.
std::size_t find_not_finite(const double* rows, std::size_t count, std::size_t stride);

/// Says so where a contact of the lightest bodies lasts less than eight time steps; empty otherwise. `k_n` is the
/// largest stiffness; bodies are "grains" or "bodies".
std::string step_too_long(double dt, double lightest, double k_n, const char* bodies);

}  // namespace jam
