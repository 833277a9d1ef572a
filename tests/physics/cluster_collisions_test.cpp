// Two clusters collide: restitution, momentum, angular momentum, energy.
#include <gtest/gtest.h>

#include <numbers>

#include "cluster_scenes.hpp"
#include "jamscape/dem/cluster_contact.hpp"

namespace jam {
namespace {

using scenes::after_contact;
using scenes::now;

/// Separation over approach speed in a head-on collision with S3's damping ratio, .2.
double restitution(const ClusterShape& shape, const Quaternion& second, bool clipped, double scale = 1) {
  ClusterSetup s = scenes::two_bodies(shape, 0.02, 0.001);
  s.grain_law = scenes::s3_law(0.2, 0.5, clipped);
  s.bodies.scale = {1, scale};
  s.bodies.position[1] = {0, 0, (1 + scale) / 2 + 0.01};
  s.bodies.velocity = {Vec3{0, 0, 0.01}, Vec3{0, 0, -0.01}};
  s.bodies.orientation[1] = second;
  ClusterEngine engine(s);
  const Packing p = after_contact(engine);
  EXPECT_EQ(p.grains.spin[0], Vec3{});
  return (p.grains.velocity[1][2] - p.grains.velocity[0][2]) / 0.02;
}

TEST(ClusterRestitution, one_number_for_all_bodies) {
  const Quaternion across = scenes::turn_about({0, 0, 1}, std::numbers::pi / 2);
  EXPECT_NEAR(restitution(sphere_shape(), {}, false), 0.5266, 3e-4);
  EXPECT_NEAR(restitution(sphere_shape(), {}, true), 0.5717, 3e-4);
  EXPECT_NEAR(restitution(sphere_shape(), {}, true, 0.7), 0.5717, 3e-4);
  EXPECT_NEAR(restitution(rod_shape(5), across, false), 0.5266, 3e-4);
  EXPECT_NEAR(restitution(rod_shape(5), across, true), 0.5717, 3e-4);
  EXPECT_NEAR(restitution(rod_shape(5), scenes::turn_about({0, 0, 1}, 1.0), true), 0.5717, 3e-4);
}

struct Outcome {
  double energy_error = 0, momentum_error = 0, angular_error = 0;
  bool near_parallel = false;
};

/// A collision with random orientations, spins and impact parameter.
Outcome collide(const ClusterShape& shape, std::uint64_t number, double dt, const PairLaw<>& law, bool planar = false,
                ParallelRule rule = ParallelRule::middle) {
  Random random(11, "collisions", number, "scene");
  ClusterSetup s = scenes::two_bodies(shape, 0.1, dt);
  s.planar = planar;
  s.parallel = rule;
  s.grain_law = law;
  const auto vector = [&](double most) {
    return Vec3{random.uniform(-most, most), random.uniform(-most, most), random.uniform(-most, most)};
  };
  const double width = shape.circumradius;
  for (std::size_t k = 0; k < 2; ++k) {
    s.bodies.orientation[k] =
        planar ? scenes::turn_about({0, 0, 1}, random.uniform(0, 7)) : scenes::random_turn(random);
    s.bodies.spin[k] = vector(0.02);
    if (planar) s.bodies.spin[k] = {0, 0, s.bodies.spin[k][2]};
  }
  s.bodies.position[1][1] = random.uniform(-width, width) * 0.5;
  if (!planar) s.bodies.position[1][2] = random.uniform(-width, width) * 0.5;
  ClusterEngine engine(s);
  const Packing before = now(engine);
  Outcome out;
  bool touched = false;
  int apart = 0;
  Packing after;
  for (int k = 0; k < 1000000 && apart < 100; ++k) {
    after = now(engine);
    for (std::size_t c = 0; c < after.contacts.size(); ++c) {
      const auto direction = [&](std::uint32_t body, std::uint16_t arm) {
        return rotate(after.grains.orientation[body], shape.arms[arm].direction);
      };
      const double a = dot(direction(after.contacts.i[c], after.contacts.part_i[c]),
                           direction(static_cast<std::uint32_t>(after.contacts.j[c]), after.contacts.part_j[c]));
      out.near_parallel = out.near_parallel || 1 - a * a < 2e-3;
    }
    const bool touching = after.contacts.size() > 0;
    touched = touched || touching;
    apart = touched && !touching ? apart + 1 : 0;
    if (!touched && after.time > 40 * width) break;  // missed
  }
  out.energy_error = after.energy.sum() / before.energy.sum() - 1;
  out.momentum_error = norm(scenes::momentum(after) - scenes::momentum(before));
  out.angular_error = norm(scenes::angular_momentum(after, s.density) - scenes::angular_momentum(before, s.density));
  return out;
}

TEST(ClusterCollision, momentum_and_angular_momentum_to_round_off) {
  for (const ClusterShape& shape : {rod_shape(4), cross_shape(3), star_shape(4), star_shape(1.1)})
    for (std::uint64_t k = 0; k < 4; ++k) {
      const Outcome out = collide(shape, k, 0.02, scenes::s3_law(0.2, 0.5));
      EXPECT_LT(out.momentum_error, 1e-14) << shape.name << k;
      EXPECT_LT(out.angular_error, 1e-13) << shape.name << k;
    }
  for (const ClusterShape& shape : {cross_shape(3), rod_shape(4)}) {
    const Outcome out = collide(shape, 5, 0.02, scenes::s3_law(0.2, 0.5), true);
    EXPECT_LT(out.momentum_error, 1e-14);
    EXPECT_LT(out.angular_error, 1e-13);
  }
}

/// Root mean square of the energy errors of elastic collisions that stay clear of the parallel rule.
double elastic_error(const ClusterShape& shape, double dt, bool planar) {
  double sum = 0;
  int count = 0;
  for (std::uint64_t k = 0; k < 24; ++k) {
    const Outcome out = collide(shape, k, dt, scenes::s3_law(0, 0), planar);
    if (out.near_parallel) continue;
    sum += out.energy_error * out.energy_error;
    ++count;
  }
  EXPECT_GE(count, 4);
  return std::sqrt(sum / count);
}

// Contacts begin and end between steps, which leaves second order but makes the error scatter.
TEST(ClusterCollision, elastic_energy_is_kept_to_second_order) {
  for (const bool planar : {false, true})
    for (const ClusterShape& shape : {rod_shape(4), cross_shape(3), star_shape(4)}) {
      if (planar && shape.arms.size() == 3) continue;
      const double coarse = elastic_error(shape, 0.08, planar), fine = elastic_error(shape, 0.02, planar);
      EXPECT_LT(coarse, 0.02) << shape.name;
      EXPECT_LT(fine, coarse / 8) << shape.name << " " << coarse;
    }
}

// First order, as dissipation is booked with the velocities that the forces see.
TEST(ClusterCollision, the_ledger_closes_with_friction_and_damping) {
  for (std::uint64_t k = 0; k < 6; ++k)
    for (const ClusterShape& shape : {star_shape(4), cross_shape(3)}) {
      const Outcome coarse = collide(shape, k, 0.02, scenes::s3_law(0.2, 0.5)),
                    fine = collide(shape, k, 0.005, scenes::s3_law(0.2, 0.5));
      if (fine.near_parallel) continue;
      EXPECT_LT(std::abs(coarse.energy_error), 0.06);
      EXPECT_LT(std::abs(fine.energy_error), std::abs(coarse.energy_error) / 3);
    }
}

/// Two arms, the second .9 above the middle of the first and turned by `angle` about its own middle at x = 2.
template <ParallelRule rule>
ArmTouch<double> at_angle(double angle) {
  const double one[] = {0, 0, 0, 0.5, 1, 0, 0, 3}, two[] = {2, 0.9, 0, 0.5, std::cos(angle), std::sin(angle), 0, 3};
  const double bound = std::sin(std::numbers::pi / 90);
  return touch_arms<rule>(one, two, bound * bound);
}

TEST(ParallelArms, overlap_and_normal_are_continuous_and_the_point_moves_by_the_rule) {
  const double bound = std::numbers::pi / 90, step = 1e-9;
  for (const double side : {-1.0, 1.0}) {
    const auto inside = at_angle<ParallelRule::middle>(side * (bound - step)),
               outside = at_angle<ParallelRule::middle>(side * (bound + step));
    EXPECT_NEAR(inside.overlap, outside.overlap, 1e-7);
    EXPECT_LT(norm(inside.normal - outside.normal), 1e-7);
    EXPECT_NEAR(inside.point[0], 1, 0.03);  // side by side from -1 to 3
    EXPECT_GT(norm(inside.point - outside.point), 1.9);
    const auto blended = at_angle<ParallelRule::blend>(side * (bound - step)),
               sharp = at_angle<ParallelRule::blend>(side * (bound + step));
    EXPECT_LT(norm(blended.point - sharp.point), 1e-6);
    EXPECT_EQ(sharp.point, outside.point);
  }
  EXPECT_LT(norm(at_angle<ParallelRule::blend>(0).point - at_angle<ParallelRule::middle>(0).point), 1e-12);
  EXPECT_LT(norm(at_angle<ParallelRule::blend>(1e-9).point - at_angle<ParallelRule::blend>(-1e-9).point), 1e-6);
  // the point lies half the overlap inside the first arm, on the line of the closest points
  EXPECT_NEAR(at_angle<ParallelRule::middle>(0).point[1], 0.45, 1e-15);
}

/// Mean and root mean square of the energy that elastic collisions of nearly parallel rods gain.
struct Drift {
  double mean = 0, rms = 0;
};
Drift parallel_drift(ParallelRule rule, double dt) {
  Drift drift;
  const int count = 60;
  Random random(4, "parallel", 0, "scene");
  for (int k = 0; k < count; ++k) {
    ClusterSetup s = scenes::two_bodies(rod_shape(6), 0.1, dt);
    s.parallel = rule;
    s.bodies.position[1] = {random.uniform(-4, 4), 1.15, 0};
    s.bodies.velocity = {Vec3{0, 0.05, 0}, Vec3{0, -0.05, 0}};
    s.bodies.orientation[1] = scenes::turn_about({0, 0, 1}, random.uniform(-0.034, 0.034));
    ClusterEngine engine(s);
    const double before = scenes::now(engine).energy.sum(), change = after_contact(engine).energy.sum() / before - 1;
    drift.mean += change / count;
    drift.rms += change * change / count;
  }
  drift.rms = std::sqrt(drift.rms);
  return drift;
}

// Moving the point alone makes the torque non-conservative within the 2 degrees. Measured, of the energy of a collision
// along the sides (mean, root mean square): middle -.008, .015; blend -.23, .29. It does not depend on the time step.
TEST(ClusterCollision, drift_of_the_parallel_rule) {
  const Drift middle = parallel_drift(ParallelRule::middle, 0.02), blend = parallel_drift(ParallelRule::blend, 0.02);
  EXPECT_LT(std::abs(middle.mean), 0.02);
  EXPECT_LT(middle.rms, 0.03);
  EXPECT_LT(std::abs(blend.mean), 0.3);
  EXPECT_LT(blend.rms, 0.4);
}

}  // namespace
}  // namespace jam
