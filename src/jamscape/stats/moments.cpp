#include "jamscape/stats/moments.hpp"

#include <cmath>

#include "jamscape/stats/none.hpp"

namespace jam {

Moments moments(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  Moments m{values.size(), none, none, none};
  if (values.empty()) return m;
  double sum = 0;
  for (const double x : values) sum += x;
  m.mean = sum / n;
  if (values.size() < 2) return m;
  double squares = 0;
  for (const double x : values) squares += (x - m.mean) * (x - m.mean);
  m.sd = std::sqrt(squares / (n - 1));
  m.se = m.sd / std::sqrt(n);
  return m;
}

}  // namespace jam
