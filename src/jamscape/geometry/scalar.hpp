// The few functions that formulas need of a scalar, for double. geometry/lanes.hpp offers the same for a SIMD vector
// of doubles, so that one template serves both. Inlined always: the object files built for wider vectors must not lend
// their copies to the rest of the program.
#pragma once

#include <cmath>

#define JAM_INLINE inline __attribute__((always_inline))

namespace jam {

JAM_INLINE double square_root(double a) { return __builtin_sqrt(a); }
JAM_INLINE double magnitude(double a) { return __builtin_fabs(a); }
JAM_INLINE double smaller(double a, double b) { return a < b ? a : b; }
JAM_INLINE double larger(double a, double b) { return a > b ? a : b; }
/// c + a b and c - a b, rounded once. Without such an instruction, a library call: exact, but slow.
JAM_INLINE double add_product_once(double c, double a, double b) { return __builtin_fma(a, b, c); }
JAM_INLINE double subtract_product_once(double c, double a, double b) { return __builtin_fma(-a, b, c); }
/// Whether a condition holds for any of the numbers side by side.
JAM_INLINE bool any(bool condition) { return condition; }
/// a where the condition holds, else b.
JAM_INLINE double select(bool condition, double a, double b) { return condition ? a : b; }

}  // namespace jam
