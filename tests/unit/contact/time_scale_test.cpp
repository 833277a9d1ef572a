// The table of theory sec. 2.2: hydrogel spheres of S2 (Y = 23.45 kPa, sigma = .5, d = 1.735 cm, m = 3.0 g, v0 = .01
// cm/s).
#include "jamscape/contact/time_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace jam {
namespace {

constexpr double young = 23450, poisson = 0.5, d = 0.01735, m = 0.003, v0 = 1e-4;

TEST(TimeScale, PrefactorsAsPrinted) {
  EXPECT_NEAR(collision_prefactor(0), std::numbers::pi, 1e-14);
  EXPECT_NEAR(collision_prefactor(0.5), 2.943275, 5e-7);
}

TEST(TimeScale, StiffnessOfTheMaterial) {
  EXPECT_NEAR(material_stiffness(young, poisson, d, 0), 361.7, 0.05) << "N/m";
  EXPECT_NEAR(material_stiffness(young, poisson, d, 0.5), 2746, 0.5) << "N/m^1.5";
}

struct Row {
  double mbar, beta, tau_c, k_n, speed;  // ms, scaled, scaled
};

class Table22 : public testing::TestWithParam<Row> {};

TEST_P(Table22, IsReproduced) {
  const Row& r = GetParam();
  const double k = material_stiffness(young, poisson, d, r.beta), tau = collision_time(r.mbar, k, v0, r.beta);
  EXPECT_NEAR(tau * 1e3, r.tau_c, 6e-4 * r.tau_c);
  EXPECT_NEAR(k * tau * tau * std::pow(d, r.beta) / m, r.k_n, 1e-4 * r.k_n);
  EXPECT_NEAR(v0 * tau / d, r.speed, 2e-3 * r.speed);
}

INSTANTIATE_TEST_SUITE_P(AllRows, Table22,
                         testing::Values(Row{m / 2, 0, 6.398, 4.9348, 3.69e-5}, Row{m / 2, 0.5, 63.47, 485.65, 3.66e-4},
                                         Row{m, 0, 9.048, 9.8696, 5.22e-5}, Row{m, 0.5, 83.75, 845.6, 4.83e-4}));

// The formula against the collision itself, integrated with velocity Verlet.
TEST(TimeScale, IsTheDurationOfAnElasticCollision) {
  for (const double beta : {0.0, 0.5}) {
    const double mbar = 0.7, k = 3, v = 0.2, tau = collision_time(mbar, k, v, beta), dt = tau * 1e-5;
    double x = 0, u = v, t = 0;
    const auto acceleration = [&](double y) { return y > 0 ? -k / mbar * std::pow(y, 1 + beta) : 0.0; };
    do {
      u += acceleration(x) * dt / 2;
      x += u * dt;
      u += acceleration(x) * dt / 2;
      t += dt;
    } while (x > 0);
    EXPECT_NEAR(t, tau, 3e-5 * tau) << beta;
    EXPECT_NEAR(u, -v, 1e-4 * v) << beta;
  }
}

}  // namespace
}  // namespace jam
