#include "jamscape/observe/particle_stress.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "jamscape/geometry/cluster_shape.hpp"
#include "jamscape/observe/bodies.hpp"
#include "jamscape/observe/box.hpp"
#include "jamscape/observe/stress.hpp"
#include "packings.hpp"

namespace jam {
namespace {

using namespace test;

constexpr double pi = std::numbers::pi;

double trace(const Tensor& s) { return s[0][0] + s[1][1] + s[2][2]; }

TEST(ParticleStress, OfADiscBetweenTwoPlates) {
  Packing p = box(2, {9, 1, 0});
  add_walls(p);
  add_grain(p, {4, 0.5, 0});
  add_contact(p, 0, -3, 3);
  add_contact(p, 0, -4, 3);
  const Tensor s = particle_stresses(p)[0];
  EXPECT_DOUBLE_EQ(s[1][1], -2 * 3 * 0.5 / (pi / 4));
  EXPECT_EQ(s[0][0], 0);
  EXPECT_EQ(asymmetry(s), 0);
  p.dimension = 3;
  EXPECT_DOUBLE_EQ(particle_stresses(p)[0][1][1], -2 * 3 * 0.5 / (pi / 6));
}

TEST(ParticleStress, OfACrossIsPerVolumeOfItsUnion) {
  // Scaled by 2, tips at +-4 on each axis, pressed along x by plates and twisted by a couple at its upper tip.
  Packing p = box(2, {8, 30, 0});
  p.shapes = {cross_shape(4)};
  add_walls(p);
  add_body(p, {4, 9, 0}, 0, 2);
  const double volume = 8 * p.shapes[0].volume;
  EXPECT_DOUBLE_EQ(body_volume(p, 0), volume);
  EXPECT_NEAR(volume, 8 * 5.09292, 1e-4);  // theory sec. 2.6
  add_contact_at(p, 0, -1, {0, 9, 0}, {-1, 0, 0}, 5);
  add_contact_at(p, 0, -2, {8, 9, 0}, {1, 0, 0}, 5, {0, 0.25, 0});
  const Tensor s = particle_stresses(p)[0];
  EXPECT_NEAR(s[0][0], -(5 * 4 + 5 * 4) / volume, 1e-12);
  EXPECT_NEAR(s[1][0], 0.25 * 4 / volume, 1e-12);  // f_y l_x
  EXPECT_EQ(s[0][1], 0);
  EXPECT_NEAR(asymmetry(s), std::sqrt(0.5) / std::hypot(40, 1), 1e-12);
}

TEST(ParticleStress, OfBothBodiesOfAContactAcrossThePeriodicSide) {
  Packing p = box(2, {10, 5, 0}, true);
  add_grain(p, {0.4, 2, 0});
  add_grain(p, {9.4, 2, 0});
  add_contact(p, 0, 1, 3, {0, 1, 0}, {-1, 0, 0});
  for (const Tensor& s : particle_stresses(p)) {
    EXPECT_NEAR(s[0][0], -3 * 0.5 / (pi / 4), 1e-12);
    EXPECT_NEAR(s[1][0], -1 * 0.5 / (pi / 4), 1e-12);
  }
}

// sum over bodies of V_i sigma_i = V sigma, whatever the contact points.
TEST(ParticleStress, AddsUpToTheStressOfTheBox) {
  Packing p = box(3, {12, 12, 12});
  p.shapes = {star_shape(3), rod_shape(2)};
  add_walls(p);
  Random random(4, "particle stress", 0, "clusters");
  const auto vector = [&](double size) {
    return Vec3{random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
  };
  for (int k = 0; k < 20; ++k)
    add_body(p, Vec3{6, 6, 6} + vector(5), k % 2, random.uniform(0.8, 1.2),
             normalized({random.uniform(), random.uniform(), random.uniform(), random.uniform()}));
  for (std::uint32_t i = 0; i < 19; ++i) {
    add_contact_at(p, i, -1 - static_cast<std::int32_t>(i % 6), p.grains.position[i] + vector(1), vector(1), 2,
                   vector(1));
    for (std::uint16_t arm = 0; arm < 2; ++arm) {
      const Vec3 middle = 0.5 * (p.grains.position[i] + p.grains.position[i + 1]);
      add_contact_at(p, i, static_cast<std::int32_t>(i) + 1, middle + vector(1), vector(1), random.uniform(), vector(1),
                     arm);
    }
  }
  const std::vector<Tensor> each = particle_stresses(p);
  const Tensor whole = stress(p);
  for (std::size_t a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      double sum = 0;
      for (std::size_t i = 0; i < each.size(); ++i) sum += body_volume(p, i) * each[i][a][b];
      EXPECT_NEAR(sum, box_volume(p) * whole[a][b], 1e-10);
    }
}

TEST(ParticleStress, RatiosAreOverTheMeanOfAllWithRattlers) {
  Packing p = box(2, {9, 1, 0});
  add_walls(p);
  for (const double x : {2.0, 4.0, 7.0}) add_grain(p, {x, 0.5, 0});
  add_contact(p, 0, -3, 1);
  add_contact(p, 0, -4, 1);
  add_contact(p, 1, -3, 3);
  add_contact(p, 1, -4, 3);
  EXPECT_EQ(stress_ratios(particle_stresses(p)), (std::vector<double>{0.75, 2.25, 0}));
  MeasureOptions options;
  options.contact_force_max = 3;
  options.contact_force_bins = 3;
  const Table t = stress_distribution_measure().evaluate(Snapshot(p, options));
  EXPECT_EQ(t.numbers("count"), (std::vector<double>{2, 0, 1}));  // 0 and .75 in the first bin
  EXPECT_EQ(t.numbers("density"), (std::vector<double>{2 / 3., 0, 1 / 3.}));
  const Table rows = particle_stress_measure().evaluate(Snapshot(p, {}));
  EXPECT_EQ(rows.numbers("grain"), (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(rows.numbers("i"), (std::vector<double>{0.75, 2.25, 0}));
  EXPECT_DOUBLE_EQ(rows.numbers("s1")[1], rows.numbers("i1")[1]);
  EXPECT_EQ(rows.numbers("s2")[1], 0);
}

TEST(ParticleStress, PrincipalStressesAreThoseOfTheTurnedTensor) {
  const Quaternion q = normalized({0.3, -0.5, 0.7, 0.2});
  const Vec3 values{-5, -2, 1};
  Tensor s{};  // sum of values times axis (x) axis
  for (int k = 0; k < 3; ++k) {
    Vec3 axis{};
    axis[k] = 1;
    axis = rotate(q, axis);
    for (int a = 0; a < 3; ++a) s[static_cast<std::size_t>(a)] += values[k] * axis[a] * axis;
  }
  s[0][1] += 0.4;  // an antisymmetric part changes nothing
  s[1][0] -= 0.4;
  const Vec3 found = principal_stresses(s, 3);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], values[k], 1e-12);
  EXPECT_NEAR(trace(s), -6, 1e-12);
  EXPECT_NEAR(asymmetry(s), std::sqrt(2 * 0.16 / (30 + 2 * 0.16)), 1e-12);
  const Vec3 plane = principal_stresses({Vec3{-3, 1, 0}, Vec3{1, -3, 0}, Vec3{}}, 2);
  EXPECT_NEAR(plane[0], -4, 1e-12);
  EXPECT_NEAR(plane[1], -2, 1e-12);
  EXPECT_EQ(plane[2], 0);
}

TEST(ParticleStress, OfNothingIsZero) {
  Packing p = box(3, {4, 4, 4});
  EXPECT_TRUE(stress_ratios(particle_stresses(p)).empty());
  add_grain(p, {1, 1, 1});
  EXPECT_EQ(stress_ratios(particle_stresses(p)), std::vector<double>{0});
  EXPECT_EQ(asymmetry(particle_stresses(p)[0]), 0);
}

}  // namespace
}  // namespace jam
