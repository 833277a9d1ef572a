// Sums in slots, as kernels of any vector width keep them.
#pragma once

#include "jamscape/dem/rows.hpp"

namespace jam {

inline double sum_of(const double (&slots)[block]) {
  double s = 0;
  for (const double a : slots) s += a;
  return s;
}

}  // namespace jam
