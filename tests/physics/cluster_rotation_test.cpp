// Free rotation: conserved quantities, order, the norm of the quaternion.
#include <gtest/gtest.h>

#include <numbers>

#include "cluster_scenes.hpp"

namespace jam {
namespace {

/// A body with three different moments of inertia.
ClusterSetup top(double dt, const Vec3& spin) {
  ClusterShape shape = sphere_shape();
  shape.name = "custom";
  shape.inertia = {0.5 * shape.volume, 1.0 * shape.volume, 1.3 * shape.volume};
  ClusterSetup s;
  s.shapes = {shape};
  s.density = 1 / shape.volume;
  s.bodies.shape = {0};
  s.bodies.position = {Vec3{}};
  s.bodies.spin = {spin};
  s.grain_law = s.wall_law = scenes::s3_law(0, 0);
  s.dt = dt;
  return s;
}

Packing turned(double dt, double time) {
  ClusterEngine engine(top(dt, {0.3, 1.0, 0.2}));
  engine.run(std::llround(time / dt));
  engine.compute_forces();
  return engine.record();
}

double apart(const Quaternion& a, const Quaternion& b) {
  const Quaternion d = conjugate(a) * b;
  return 2 * std::asin(std::min(1.0, std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z)));
}

TEST(FreeTop, converges_with_order_two) {
  const Quaternion exact = turned(0.0005, 20).grains.orientation[0];
  const double coarse = apart(turned(0.04, 20).grains.orientation[0], exact);
  const double fine = apart(turned(0.02, 20).grains.orientation[0], exact);
  EXPECT_LT(coarse, 0.05);
  EXPECT_NEAR(coarse / fine, 4, 0.4);
}

// Euler's equations I dw/dt + w x I w = 0 in the body's frame, by a Runge-Kutta step of fourth order.
TEST(FreeTop, follows_eulers_equations) {
  const Vec3 moment{0.5, 1.0, 1.3};
  const auto rate = [&](const Vec3& w) {
    return Vec3{(moment[1] - moment[2]) * w[1] * w[2] / moment[0], (moment[2] - moment[0]) * w[2] * w[0] / moment[1],
                (moment[0] - moment[1]) * w[0] * w[1] / moment[2]};
  };
  Vec3 w{0.3, 1.0, 0.2};
  const double h = 0.001;
  for (int k = 0; k < 20000; ++k) {
    const Vec3 a = rate(w), b = rate(w + (h / 2) * a), c = rate(w + (h / 2) * b), d = rate(w + h * c);
    w += (h / 6) * (a + 2.0 * b + 2.0 * c + d);
  }
  const Packing p = turned(0.001, 20);
  const Vec3 own = rotate(conjugate(p.grains.orientation[0]), p.grains.spin[0]);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(own[c], w[c], 2e-5);
}

TEST(FreeTop, energy_does_not_drift_and_angular_momentum_stays) {
  const ClusterSetup setup = top(0.02, {0.3, 1.0, 0.2});
  ClusterEngine engine(setup);
  const Packing start = scenes::now(engine);
  double early = 0, late = 0;
  for (int k = 0; k < 1000000; ++k) {
    engine.advance();
    if (k % 97) continue;
    double& worst = k < 500000 ? early : late;
    worst = std::max(worst, std::abs(engine.kinetic_energy() / start.energy.kinetic - 1));
  }
  engine.compute_forces();
  const Packing end = engine.record();
  EXPECT_LT(early, 1e-3);
  EXPECT_LT(late, 1.01 * early);  // it swings, and does not grow
  const double density = setup.density;
  EXPECT_EQ(norm(scenes::angular_momentum(end, density) - scenes::angular_momentum(start, density)) < 1e-12, true);
  const Quaternion& q = end.grains.orientation[0];
  EXPECT_NEAR(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, 1, 1e-14);
}

TEST(EvenTop, turns_uniformly) {
  ClusterSetup s = top(0.05, {0.6, -0.3, 0.2});
  s.shapes = {star_shape(3)};
  ClusterEngine engine(s);
  engine.run(1000);
  engine.compute_forces();
  const Packing p = engine.record();
  const Quaternion expected = scenes::turn_about({0.6, -0.3, 0.2}, 0.7 * 50);
  EXPECT_LT(apart(p.grains.orientation[0], expected), 1e-8);
  EXPECT_NEAR(p.grains.spin[0][0], 0.6, 1e-15);
  engine.run(1000000);
  engine.compute_forces();
  const Quaternion q = engine.record().grains.orientation[0];
  EXPECT_NEAR(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, 1, 1e-14);
}

}  // namespace
}  // namespace jam
