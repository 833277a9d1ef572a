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

// Products that are added: `fused` rounds once after both (fewer instructions), otherwise after each.

/// c + a b and c - a b.
template <bool fused, class T>
JAM_INLINE constexpr T add_product(const T& c, const T& a, const T& b) {
  if constexpr (fused)
    return add_product_once(c, a, b);
  else
    return c + a * b;
}
template <bool fused, class T>
JAM_INLINE constexpr T subtract_product(const T& c, const T& a, const T& b) {
  if constexpr (fused)
    return subtract_product_once(c, a, b);
  else
    return c - a * b;
}
/// u + s a and u - s a.
template <bool fused, int D, class T>
JAM_INLINE constexpr Vec<D, T> add_product(Vec<D, T> u, const T& s, const Vec<D, T>& a) {
  for (int k = 0; k < D; ++k) u[k] = add_product<fused>(u[k], s, a[k]);
  return u;
}
template <bool fused, int D, class T>
JAM_INLINE constexpr Vec<D, T> subtract_product(Vec<D, T> u, const T& s, const Vec<D, T>& a) {
  for (int k = 0; k < D; ++k) u[k] = subtract_product<fused>(u[k], s, a[k]);
  return u;
}

/// Of numbers, their product.
template <bool fused = false, class T>
JAM_INLINE constexpr T dot(const T& a, const T& b) {
  return a * b;
}
template <bool fused = false, int D, class T>
JAM_INLINE constexpr T dot(const Vec<D, T>& a, const Vec<D, T>& b) {
  T s = a[0] * b[0];
  for (int k = 1; k < D; ++k) s = add_product<fused>(s, a[k], b[k]);
  return s;
}

template <bool fused = false, class T>
JAM_INLINE constexpr Vec<3, T> cross(const Vec<3, T>& a, const Vec<3, T>& b) {
  return {subtract_product<fused>(a[1] * b[2], a[2], b[1]), subtract_product<fused>(a[2] * b[0], a[0], b[2]),
          subtract_product<fused>(a[0] * b[1], a[1], b[0])};
}
/// u + a x b.
template <bool fused, class T>
JAM_INLINE constexpr Vec<3, T> add_cross(const Vec<3, T>& u, const Vec<3, T>& a, const Vec<3, T>& b) {
  if constexpr (!fused) return u + cross(a, b);
  Vec<3, T> sum;
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    sum[k] = subtract_product<fused>(add_product<fused>(u[k], a[l], b[m]), a[m], b[l]);
  }
  return sum;
}

/// Component by component.
template <int D, class T, class Condition>
JAM_INLINE Vec<D, T> select(Condition condition, const Vec<D, T>& a, const Vec<D, T>& b) {
  Vec<D, T> c;
  for (int k = 0; k < D; ++k) c[k] = select(condition, a[k], b[k]);
  return c;
}

template <int D>
JAM_INLINE double norm(const Vec<D>& a) {
  return std::sqrt(dot(a, a));
}

using Vec2 = Vec<2>;
using Vec3 = Vec<3>;

}  // namespace jam
