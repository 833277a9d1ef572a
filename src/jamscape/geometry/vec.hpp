// Small vectors of D components over a scalar type T, which may be double or a SIMD vector of doubles: the same
// formula serves one contact or eight.
#pragma once

#include <cmath>

#include "jamscape/geometry/scalar.hpp"

namespace jam {

template <int D, class T = double>
struct Vec {
  T c[D];

  JAM_INLINE constexpr T& operator[](int k) { return c[k]; }
  JAM_INLINE constexpr const T& operator[](int k) const { return c[k]; }
  bool operator==(const Vec&) const = default;
};

template <int D, class T>
JAM_INLINE constexpr Vec<D, T> operator+(Vec<D, T> a, const Vec<D, T>& b) {
  for (int k = 0; k < D; ++k) a[k] = a[k] + b[k];
  return a;
}
template <int D, class T>
JAM_INLINE constexpr Vec<D, T> operator-(Vec<D, T> a, const Vec<D, T>& b) {
  for (int k = 0; k < D; ++k) a[k] = a[k] - b[k];
  return a;
}
template <int D, class T>
JAM_INLINE constexpr Vec<D, T> operator*(const T& s, Vec<D, T> a) {
  for (int k = 0; k < D; ++k) a[k] = s * a[k];
  return a;
}
template <int D, class T>
JAM_INLINE constexpr Vec<D, T>& operator+=(Vec<D, T>& a, const Vec<D, T>& b) {
  return a = a + b;
}
template <int D, class T>
JAM_INLINE constexpr Vec<D, T>& operator-=(Vec<D, T>& a, const Vec<D, T>& b) {
  return a = a - b;
}

template <int D, class T>
JAM_INLINE constexpr T dot(const Vec<D, T>& a, const Vec<D, T>& b) {
  T s = a[0] * b[0];
  for (int k = 1; k < D; ++k) s = s + a[k] * b[k];
  return s;
}

template <class T>
JAM_INLINE constexpr Vec<3, T> cross(const Vec<3, T>& a, const Vec<3, T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <int D>
JAM_INLINE double norm(const Vec<D>& a) {
  return std::sqrt(dot(a, a));
}

using Vec2 = Vec<2>;
using Vec3 = Vec<3>;

}  // namespace jam
