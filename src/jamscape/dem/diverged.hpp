// The error of a simulation that left the sane.
#pragma once

#include <stdexcept>

namespace jam {

/// An overlap beyond a radius, a grain outside its box, or a number that is none. what() names the step, the grain, its
/// place, and the likely cause.
class Diverged : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace jam
