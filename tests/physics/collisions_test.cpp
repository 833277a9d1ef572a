// Single contacts against closed forms (theory sec. 2.1, 2.5, 6b; Chung & Ooi 2011).
#include <gtest/gtest.h>

#include "jamscape/base/error.hpp"
#include "two_bodies.hpp"

namespace jam {
namespace {

using scenes::after_contact;
using scenes::head_on;
using scenes::s1_law;

template <int D>
double restitution(const PairLaw<>& law, double dt, Scheme scheme, double gap = 0.01) {
  Engine<D> engine(head_on<D>(law, 0.05, dt, scheme, gap));
  after_contact<D>(engine);
  engine.run(50);  // Gear forgets the contact's acceleration over some steps
  engine.compute_forces();
  const Packing p = engine.record();
  return (p.grains.velocity[1][0] - p.grains.velocity[0][0]) / 0.05;
}

TEST(Damping, solves_for_the_restitution_asked_for) {
  EXPECT_NEAR(
      solve_damping(NormalLaw::linear, DampingRule::unclipped, std::numbers::pi * std::numbers::pi / 2, 0.5, 0.5, 1),
      1.35374, 1e-5);
  EXPECT_NEAR(
      solve_damping(NormalLaw::linear, DampingRule::clipped, std::numbers::pi * std::numbers::pi / 2, 0.5, 0.5, 1),
      1.604, 1e-3);
  const double z = 1.35374 / (2 * std::numbers::pi);  // the unclipped damping for e = .5
  EXPECT_NEAR(linear_restitution(z, DampingRule::clipped), 0.550, 1e-3);
  EXPECT_NEAR(linear_restitution(z, DampingRule::printed), 0.699, 1e-3);
  EXPECT_THROW(solve_damping(NormalLaw::linear, DampingRule::printed, 1, 0.5, 0.3, 1), Error);
}

TEST(HeadOn, restitution_of_every_damping_rule_in_both_dimensions) {
  for (const DampingRule rule : {DampingRule::unclipped, DampingRule::clipped, DampingRule::printed}) {
    ContactOptions o;
    o.restitution = rule == DampingRule::printed ? 0.8 : 0.5;
    o.damping = rule;
    const PairLaw<> law = grain_law(o, 1.0);
    EXPECT_NEAR(restitution<2>(law, 1e-4, Scheme::verlet), o.restitution, 2e-4);
    EXPECT_NEAR(restitution<3>(law, 1e-4, Scheme::verlet), o.restitution, 2e-4);
  }
}

// Contact onset falls anywhere within a step: theory sec. 2.5 gives the scatter at dt = .02.
TEST(HeadOn, restitution_at_the_time_step_of_the_studies) {
  for (const auto& [scheme, mean, lowest, highest] :
       {std::tuple{Scheme::gear5, 0.4998, 0.489, 0.503}, std::tuple{Scheme::verlet, 0.4976, 0.4956, 0.510}}) {
    double sum = 0;
    constexpr int cases = 50;
    for (int k = 0; k < cases; ++k) {
      const double e = restitution<2>(s1_law(0.5, 0), 0.02, scheme, 0.01 + 0.001 * k / cases);
      EXPECT_GT(e, lowest - 0.002);
      EXPECT_LT(e, highest + 0.002);
      sum += e;
    }
    EXPECT_NEAR(sum / cases, mean, 0.002);
  }
}

TEST(HeadOn, half_an_undamped_period_lasts_one_time_unit) {
  Engine<2> engine(head_on<2>(s1_law(1.0, 0), 0.05, 1e-4, Scheme::verlet));
  const scenes::Impact impact = scenes::watch(engine, 30000);
  EXPECT_NEAR(impact.last - impact.first, 1.0, 5e-4);
  EXPECT_NEAR(impact.deepest, 0.05 / std::numbers::pi, 1e-5);  // v sqrt(mbar/k) = v / pi
}

// Chung & Ooi test 4 in 2D: a disc hits a plane that slides throughout. v_x' = v_x - mu (1 + e) v_n,
// w' = mu (1 + e) v_n m R / I; the sign of w follows from the lever arm.
TEST(Oblique, gross_sliding_against_a_plane) {
  for (const double mu : {0.05, 0.1}) {
    EngineSetup<2> s;
    s.radius = {0.5};
    s.mass = {1};
    s.inertia = {0.125};
    s.position = {Vec2{0, 0.51}};
    s.velocity = {Vec2{0.2, -0.05}};
    s.walls = {{WallKind::plane, 1, false, 0.0, 0, 0, {}}};
    s.grain_law = s.wall_law = s1_law(1.0, mu);
    s.dt = 1e-5;
    Engine<2> engine(s);
    const Packing p = after_contact<2>(engine);
    EXPECT_NEAR(p.grains.velocity[0][1], 0.05, 1e-5);
    EXPECT_NEAR(p.grains.velocity[0][0], 0.2 - mu * 2 * 0.05, 1e-5);
    EXPECT_NEAR(p.grains.spin[0][2], -mu * 2 * 0.05 * 0.5 / 0.125, 1e-5);
  }
}

TEST(Oblique, gross_sliding_of_two_spheres_in_space) {
  constexpr double mu = 0.05, v = 1e-4;  // slow, so that the pair hardly turns during the contact
  auto s = head_on<3>(s1_law(1.0, mu), 2 * v, 1e-4, Scheme::verlet, 1e-6);
  s.velocity[0][1] = 4 * v;
  s.velocity[1][1] = -4 * v;
  Engine<3> engine(s);
  const Packing p = after_contact<3>(engine);
  // each changes by mu (1 + e) v_n with v_n the speed against the common centre
  EXPECT_NEAR(p.grains.velocity[0][1] / v, 4 - mu * 2, 1e-3);
  EXPECT_NEAR(p.grains.spin[0][2] / v, -2.5 * mu * 2 / 0.5, 1e-2);
  EXPECT_NEAR(p.grains.spin[1][2] / v, p.grains.spin[0][2] / v, 1e-9);
}

// A sphere that spins but does not slide forward is kicked sideways by mu (1 + e) v_n.
TEST(Oblique, spinning_impact) {
  EngineSetup<2> s;
  s.radius = {0.5};
  s.mass = {1};
  s.inertia = {0.125};
  s.position = {Vec2{0, 0.51}};
  s.velocity = {Vec2{0, -0.05}};
  s.spin = {2.0};
  s.walls = {{WallKind::plane, 1, false, 0.0, 0, 0, {}}};
  s.grain_law = s.wall_law = s1_law(1.0, 0.1);
  s.dt = 1e-5;
  Engine<2> engine(s);
  const Packing p = after_contact<2>(engine);
  EXPECT_NEAR(std::abs(p.grains.velocity[0][0]), 0.1 * 2 * 0.05, 1e-5);
  EXPECT_LT(p.grains.velocity[0][0], 0) << "counter-clockwise spin on a floor drives the disc to the left";
}

TEST(Friction, a_sticking_contact_springs_back) {
  // Two discs pressed together by planes, displaced tangentially within the Coulomb limit: the tangential force is k_t
  // xi.
  const PairLaw<> law = s1_law(0.5, 0.5);
  double spring = 0;
  const Vec2 n{1, 0}, v{0, 0.01};
  TouchForce<2, double> f{};
  for (int k = 0; k < 100; ++k) f = touch<2, NormalLaw::linear, true>(law, n, 0.1, 0.5, v, 0.0, spring, 0.01);
  EXPECT_NEAR(spring, 0.01, 1e-12);
  EXPECT_NEAR(f.tangential, -law.k_t * 0.01 - law.gamma_t * 0.5 * 0.01, 1e-12);
  for (int k = 0; k < 10000; ++k) f = touch<2, NormalLaw::linear, true>(law, n, 0.1, 0.5, v, 0.0, spring, 0.01);
  EXPECT_NEAR(std::abs(f.tangential), law.mu * f.normal, 1e-12);
  EXPECT_NEAR(-law.k_t * spring - law.gamma_t * 0.5 * 0.01, f.tangential, 1e-12) << "the spring is reset to the cap";
}

}  // namespace
}  // namespace jam
