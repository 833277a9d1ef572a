// Closest points of segments: known cases, and brute force.
#include "jamscape/geometry/segments.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "jamscape/base/random.hpp"

namespace jam {
namespace {

using Axis = Segment<double>;

Vec3 unit(Vec3 v) { return (1 / norm(v)) * v; }

/// Smallest distance: in t exact for each s, in s by golden section (the distance is convex along a segment).
double brute_force(const Axis& one, const Axis& two) {
  const auto at = [&](double s) {
    const Vec3 p = one.centre + s * one.direction;
    const double t = std::clamp(dot(p - two.centre, two.direction), -two.half_length, two.half_length);
    return norm(two.centre + t * two.direction - p);
  };
  double lo = -one.half_length, hi = one.half_length;
  for (int k = 0; k < 200; ++k) {
    const double a = lo + 0.381966 * (hi - lo), b = hi - 0.381966 * (hi - lo);
    at(a) < at(b) ? hi = b : lo = a;
  }
  return std::min({at(lo), at(hi), at(-one.half_length), at(one.half_length)});
}

TEST(ClosestPoints, agree_with_brute_force) {
  Random random(3, "segments", 0, "test");
  const auto vector = [&] { return Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}; };
  for (int k = 0; k < 3000; ++k) {
    const Axis one{3.0 * vector(), unit(vector()), random.uniform(0, 4)};
    Axis two{3.0 * vector(), unit(vector()), k % 10 == 0 ? 0.0 : random.uniform(0, 4)};
    if (k % 3 == 0) two.direction = unit(one.direction + std::pow(10.0, -random.uniform(0, 18)) * vector());
    if (k % 7 == 0) two.direction = -1.0 * one.direction;
    const auto c = closest_points(one, two);
    EXPECT_NEAR(std::sqrt(c.distance2), brute_force(one, two), 1e-7) << k;  // golden section stops at about 1e-8
    EXPECT_LE(std::abs(c.s), one.half_length);
    EXPECT_LE(std::abs(c.t), two.half_length);
    const Vec3 d = two.centre + c.t * two.direction - (one.centre + c.s * one.direction);
    EXPECT_NEAR(norm(d), std::sqrt(c.distance2), 1e-12);
    EXPECT_NEAR(std::sqrt(closest_points(two, one).distance2), std::sqrt(c.distance2), 1e-7);
  }
}

TEST(ClosestPoints, known_cases) {
  const Axis x{{0, 0, 0}, {1, 0, 0}, 2};
  // skew, crossing above each other
  auto c = closest_points(x, Axis{{0.5, 0, 1}, {0, 1, 0}, 2});
  EXPECT_DOUBLE_EQ(c.distance2, 1);
  EXPECT_DOUBLE_EQ(c.s, 0.5);
  EXPECT_DOUBLE_EQ(c.t, 0);
  // end of the second against the side of the first
  c = closest_points(x, Axis{{1, 3, 0}, {0, 1, 0}, 2});
  EXPECT_DOUBLE_EQ(c.distance2, 1);
  EXPECT_DOUBLE_EQ(c.s, 1);
  EXPECT_DOUBLE_EQ(c.t, -2);
  // end against end
  c = closest_points(x, Axis{{5, 4, 0}, unit({1, 1, 0}), std::sqrt(2.0)});
  EXPECT_NEAR(c.distance2, 4 + 9, 1e-12);
  EXPECT_DOUBLE_EQ(c.s, 2);
  // parallel: side by side, and one behind the other
  c = closest_points(x, Axis{{1, 0.7, 0}, {1, 0, 0}, 2});
  EXPECT_NEAR(c.distance2, 0.49, 1e-15);
  c = closest_points(x, Axis{{6, 0, 0}, {-1, 0, 0}, 1});
  EXPECT_DOUBLE_EQ(c.distance2, 9);
  EXPECT_DOUBLE_EQ(c.s, 2);
  EXPECT_DOUBLE_EQ(c.t, 1);
  // points
  c = closest_points(Axis{{0, 0, 0}, {1, 0, 0}, 0}, Axis{{1, 2, 2}, {1, 0, 0}, 0});
  EXPECT_DOUBLE_EQ(c.distance2, 9);
  EXPECT_DOUBLE_EQ(axis_distance({{0, 0, 0}, {1, 0, 0}, 2, 0.5}, {{0, 0, 3}, {0, 1, 0}, 2, 0.5}), 3);
}

TEST(SideBySide, middle_of_the_shared_stretch) {
  const Axis x{{0, 0, 0}, {1, 0, 0}, 2};
  EXPECT_DOUBLE_EQ(side_by_side(x, Axis{{3, 1, 0}, {1, 0, 0}, 2}, 9.0), 1.5);  // 1 .. 2
  EXPECT_DOUBLE_EQ(side_by_side(x, Axis{{3, 1, 0}, {-1, 0, 0}, 2}, 9.0), 1.5);
  EXPECT_DOUBLE_EQ(side_by_side(x, Axis{{0.5, 1, 0}, {1, 0, 0}, 1}, 9.0), 0.5);  // within the first
  EXPECT_DOUBLE_EQ(side_by_side(x, Axis{{5, 1, 0}, {1, 0, 0}, 2}, 9.0), 9);      // beyond its end
  EXPECT_DOUBLE_EQ(side_by_side(Axis{{0, 0, 0}, {1, 0, 0}, 0}, x, 9.0), 0);
}

}  // namespace
}  // namespace jam
