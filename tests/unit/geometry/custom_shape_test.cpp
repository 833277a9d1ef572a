#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "jamscape/base/error.hpp"
#include "jamscape/base/random.hpp"
#include "jamscape/geometry/arm_union.hpp"
#include "jamscape/geometry/cluster_shape.hpp"
#include "jamscape/geometry/exposed.hpp"
#include "jamscape/geometry/quaternion.hpp"

namespace jam {
namespace {

using std::numbers::pi;

/// Two rods of different thickness end to end at an angle, and a third that stands on them.
std::vector<Arm> crooked() {
  return {
      {{0, 0, 0}, {1, 0, 0}, 1.5, 0.5}, {{1.5, 0.8, 0}, {0, 1, 0}, 0.8, 0.4}, {{-1, 0.2, 0.7}, {.6, 0, .8}, 0.9, 0.3}};
}

std::string message_of(const std::vector<Arm>& arms, int dimension) {
  try {
    custom_shape(arms, dimension);
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::usage);
    return e.what();
  }
  return "no error";
}

TEST(CustomShape, AgreesWithCountingPointsOfARegularLattice) {
  // Mid-points of a lattice of spacing a: an error of about a^2 per crossed cell, here 2e-4 of the whole at worst.
  std::vector<Arm> arms = crooked();
  const Quaternion tilt = normalized({1, .3, .5, .2});  // no axis along the lattice
  for (Arm& arm : arms) arm = {rotate(tilt, arm.centre), rotate(tilt, arm.direction), arm.half_length, arm.radius};
  const double a = 0.02;
  double volume = 0, first[3] = {}, second[3][3] = {};
  for (double x = -3; x < 3; x += a)
    for (double y = -2.5; y < 2.5; y += a)
      for (double z = -2.5; z < 2.5; z += a) {
        bool inside = false;
        for (const Arm& arm : arms) inside = inside || axis_distance2(arm, {x, y, z}) <= arm.radius * arm.radius;
        if (!inside) continue;
        const double p[3] = {x, y, z};
        volume += 1;
        for (int i = 0; i < 3; ++i) {
          first[i] += p[i];
          for (int j = 0; j < 3; ++j) second[i][j] += p[i] * p[j];
        }
      }
  const UnionIntegrals sum = integrate_union(arms);
  const double cell = a * a * a;
  EXPECT_NEAR(volume * cell, sum.volume, 5e-4 * sum.volume);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(first[i] * cell, sum.first[i], 1e-3 * sum.volume);
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(second[i][j] * cell, sum.second[i][j], 2e-3 * sum.volume) << i << j;
  }
}

TEST(CustomShape, InertiaOfRandomPointsWithinFourStandardErrors) {
  const ClusterShape shape = custom_shape(crooked(), 3);
  Random random(7, "crooked", 0, "inertia");
  constexpr std::uint64_t points = 400000;
  const double b = shape.circumradius, box = 8 * b * b * b;
  double sum[3] = {}, squares[3] = {}, mixed[3] = {};
  for (std::uint64_t k = 0; k < points; ++k) {
    Vec3 p;
    for (int i = 0; i < 3; ++i) p[i] = random.uniform(-b, b);
    bool inside = false;
    for (const Arm& arm : shape.arms) inside = inside || axis_distance2(arm, p) <= arm.radius * arm.radius;
    if (!inside) continue;
    for (int i = 0; i < 3; ++i) {
      const double y = p[(i + 1) % 3], z = p[(i + 2) % 3], v = y * y + z * z;
      sum[i] += v;
      squares[i] += v * v;
      mixed[i] += y * z;
    }
  }
  for (int i = 0; i < 3; ++i) {
    const double error = box * std::sqrt(squares[i]) / points;
    EXPECT_NEAR(sum[i] * box / points, shape.inertia[i], 4 * error);
    EXPECT_NEAR(mixed[i] * box / points, 0, 4 * error);  // principal axes
  }
}

TEST(CustomShape, TurnedAndShiftedArmsGiveTheSameBody) {
  const ClusterShape before = custom_shape(crooked(), 3);
  const double c = std::cos(0.4), s = std::sin(0.4);
  std::vector<Arm> arms = crooked();
  for (Arm& arm : arms) {
    const auto turn = [&](const Vec3& v) { return Vec3{c * v[0] - s * v[2], v[1], s * v[0] + c * v[2]}; };
    arm.centre = turn(arm.centre) + Vec3{3, -2, 5};
    arm.direction = 7.0 * turn(arm.direction);
  }
  const ClusterShape after = custom_shape(arms, 3);
  EXPECT_NEAR(after.volume, before.volume, 1e-8);
  EXPECT_NEAR(after.surface, before.surface, 1e-8);
  EXPECT_NEAR(after.circumradius, before.circumradius, 1e-7);
  Vec3 i = before.inertia, j = after.inertia;
  std::sort(i.c, i.c + 3);
  std::sort(j.c, j.c + 3);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(i[k], j[k], 1e-7);
  for (const Arm& arm : after.arms) EXPECT_NEAR(norm(arm.direction), 1, 1e-14);
}

TEST(CustomShape, ACrossTurnedInThePlaneIsTheCross) {
  std::vector<Arm> arms = cross_shape(3).arms;
  for (Arm& arm : arms) {
    arm.centre = {5, 6, 0};
    arm.direction = {arm.direction[0] + arm.direction[1], arm.direction[1] - arm.direction[0], 0};
  }
  const ClusterShape shape = custom_shape(arms, 2), cross = cross_shape(3);
  EXPECT_NEAR(shape.volume, cross.volume, 1e-9);
  EXPECT_NEAR(shape.area, cross.area, 1e-9);
  EXPECT_NEAR(shape.inertia[2], cross.inertia[2], 1e-9);
  for (const Arm& arm : shape.arms) EXPECT_NEAR(norm(arm.centre), 0, 1e-10);
}

TEST(CustomShape, ArmsThatShareTheirBoundaryCountItOnce) {
  // The same rod twice, a rod of two collinear pieces, a sphere at a rod's end: all are one rod.
  const ClusterShape rod = rod_shape(4);
  const Vec3 x{1, 0, 0};
  for (const std::vector<Arm>& arms : {std::vector<Arm>{{{}, x, 1.5, .5}, {{}, x, 1.5, .5}},
                                       std::vector<Arm>{{{-.5, 0, 0}, x, 1, .5}, {{.5, 0, 0}, x, 1, .5}},
                                       std::vector<Arm>{{{}, x, 1.5, .5}, {{1.5, 0, 0}, x, 0, .5}}}) {
    const ClusterShape shape = custom_shape(arms, 3);
    EXPECT_NEAR(shape.volume, rod.volume, 1e-8);
    EXPECT_NEAR(shape.surface, rod.surface, 1e-8);
    EXPECT_NEAR(shape.area, rod.area, 1e-8);
    EXPECT_NEAR(shape.inertia[0], rod.inertia[0], 1e-8);
    EXPECT_NEAR(shape.inertia[1], rod.inertia[1], 1e-8);
    EXPECT_NEAR(shape.circumradius, rod.circumradius, 1e-8);
  }
}

TEST(CustomShape, AnElbowIsTwoRodsLessWhatTheyShare) {
  const std::vector<Arm> arms = {{{2, 0, 0}, {1, 0, 0}, 2, .5}, {{0, 2, 0}, {0, 1, 0}, 2, .5}};
  const UnionIntegrals sum = integrate_union(arms);
  // Shared: x,y > 0: bicylinder quarter (4/3 r^3); x,y < 0: quarter ball (pi/3 r^3); x > 0 > y and y > 0 > x: quarter
  // balls.
  const double r3 = .125, shared = (4.0 / 3 + pi) * r3;
  EXPECT_NEAR(sum.volume, 2 * rod_shape(5).volume - shared, 1e-9);
}

TEST(CustomShape, TwoBallsAreALens) {
  const double d = 0.6, r = 0.5;  // distance of the centres
  const ClusterShape shape = custom_shape({{{0, 0, 0}, {1, 0, 0}, 0, r}, {{d, 0, 0}, {0, 0, 2}, 0, r}}, 3);
  const double lens = pi / 12 * (4 * r + d) * (2 * r - d) * (2 * r - d);
  EXPECT_NEAR(shape.volume, 2 * pi / 6 - lens, 1e-9);
  EXPECT_NEAR(shape.surface, 2 * pi - 2 * 2 * pi * r * (r - d / 2), 1e-9);
  const double chord = 2 * std::acos(d / (2 * r)), shared = r * r * (chord - std::sin(chord));
  EXPECT_NEAR(shape.area, pi / 2 - shared, 1e-9);
}

TEST(CustomShape, BadArms) {
  const Arm good{{}, {1, 0, 0}, 1, .5};
  EXPECT_NE(message_of({}, 3).find("at least one arm"), std::string::npos);
  EXPECT_NE(message_of({good, {{0, 5, 0}, {1, 0, 0}, 1, .5}}, 3).find("not one body"), std::string::npos);
  EXPECT_NE(message_of({good, {{0, 1, 0}, {1, 0, 0}, 1, .5}}, 3).find("not one body"),
            std::string::npos);  // only touching
  EXPECT_NE(message_of({{{}, {1, 0, 0}, -.1, .5}}, 3).find("shorter than it is thick"), std::string::npos);
  EXPECT_NE(message_of({{{}, {0, 0, 0}, 1, .5}}, 3).find("no length"), std::string::npos);
  EXPECT_NE(message_of({good, {{0, 0, 0}, {0, 0, 1}, 1, .5}}, 2).find("arm 2"), std::string::npos);
  EXPECT_NE(message_of({{{0, 0, .1}, {1, 0, 0}, 1, .5}}, 2).find("plane z = 0"), std::string::npos);
  EXPECT_NE(message_of({{{}, {1, 0, 0}, 1, 0}}, 3).find("radius 0"), std::string::npos);
  EXPECT_NE(message_of({{{std::nan(""), 0, 0}, {1, 0, 0}, 1, .5}}, 3).find("centre"), std::string::npos);
}

}  // namespace
}  // namespace jam
