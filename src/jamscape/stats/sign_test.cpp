#include "jamscape/stats/sign_test.hpp"

#include <cmath>

namespace jam {

Difference difference(const Moments& a, const Moments& b) {
  Difference d;
  d.value = a.mean - b.mean;
  d.error = std::sqrt(a.se * a.se + b.se * b.se);
  d.sigmas = d.value == 0 && d.error == 0 ? 0 : d.value / d.error;
  return d;
}

Sign sign_test(const Moments& a, const Moments& b, double sigmas) {
  const double t = difference(a, b).sigmas;
  if (t > sigmas) return Sign::above;
  if (t < -sigmas) return Sign::below;
  return Sign::undecided;
}

}  // namespace jam
