// Hertz laws against closed forms and integrated collisions (theory sec. 2.2, 6b; Chung & Ooi 2011).
#include <gtest/gtest.h>

#include "jamscape/base/error.hpp"
#include "jamscape/contact/collision.hpp"
#include "two_bodies.hpp"

namespace jam {
namespace {

using scenes::after_contact;
using scenes::head_on;

constexpr double stiffness = 485.65, slow = 3.66e-4;  // S2 in units of m, d, tau_c

PairLaw<> hertz(double e, double mu, DampingRule rule = DampingRule::clipped, NormalLaw law = NormalLaw::hertz,
                double speed = slow) {
  ContactOptions o;
  o.law = law;
  o.stiffness = stiffness;
  o.impact_speed = speed;
  o.restitution = e;
  o.friction = mu;
  o.tangential_stiffness = 6.0 / 7;
  o.damping = rule;
  return grain_law(o, 1.0);
}

TEST(HertzDamping, restitution_of_the_three_rules) {
  const double g[] = {0.1, 0.2, 0.4309, 0.6265, 1.0, 1.5};
  const double unclipped[] = {0.892, 0.798, 0.619, 0.500, 0.331, 0.184};
  const double clipped[] = {0.893, 0.801, 0.635, 0.532, 0.394, 0.281};
  const double printed[] = {0.896, 0.816, 0.709, 0.679, 0.696, 0.759};
  for (int k = 0; k < 6; ++k) {
    EXPECT_NEAR(collision_restitution(NormalLaw::hertz, DampingRule::unclipped, g[k]), unclipped[k], 6e-4);
    EXPECT_NEAR(collision_restitution(NormalLaw::hertz, DampingRule::clipped, g[k]), clipped[k], 6e-4);
    EXPECT_NEAR(collision_restitution(NormalLaw::hertz, DampingRule::printed, g[k]), printed[k], 6e-4);
  }
}

TEST(HertzDamping, solved_for_one_half) {
  EXPECT_NEAR(collision_damping(NormalLaw::hertz, DampingRule::unclipped, 0.5), 0.62649, 1e-5);
  EXPECT_NEAR(collision_damping(NormalLaw::hertz, DampingRule::clipped, 0.5), 0.69804, 1e-5);
  EXPECT_NEAR(collision_damping(NormalLaw::tsuji, DampingRule::unclipped, 0.5), 0.48177, 1e-5);
  EXPECT_NEAR(collision_damping(NormalLaw::tsuji, DampingRule::clipped, 0.5), 0.57081, 1e-5);
  EXPECT_NEAR(hertz(0.5, 0).gamma_n, 210.7, 0.1);
  EXPECT_NEAR(hertz(0.5, 0, DampingRule::unclipped).gamma_n, 189, 0.2);
  EXPECT_THROW(collision_damping(NormalLaw::hertz, DampingRule::printed, 0.5), Error);
}

/// Of a head-on collision at `speed`, in a fiftieth of S2's time step.
template <int D>
double restitution(NormalLaw kind, const PairLaw<>& law, double speed) {
  EngineSetup<D> setup = head_on<D>(law, speed, 4e-4, Scheme::verlet, speed * 1e-3);
  setup.kind = kind;
  Engine<D> engine(setup);
  const Packing p = after_contact<D>(engine);
  return (p.grains.velocity[1][0] - p.grains.velocity[0][0]) / speed;
}

TEST(HertzHeadOn, restitution_in_motion_and_its_dependence_on_speed) {
  for (const DampingRule rule : {DampingRule::clipped, DampingRule::unclipped}) {
    const PairLaw<> law = hertz(0.5, 0, rule), tsuji = hertz(0.5, 0, rule, NormalLaw::tsuji);
    EXPECT_NEAR(restitution<2>(NormalLaw::hertz, law, slow), 0.5, 2e-3);
    EXPECT_NEAR(restitution<3>(NormalLaw::hertz, law, slow), 0.5, 2e-3);
    EXPECT_NEAR(restitution<3>(NormalLaw::tsuji, tsuji, slow), 0.5, 2e-3);
    // g grows with the fifth root of the speed
    const double g = collision_damping(NormalLaw::hertz, rule, 0.5) * 2;
    EXPECT_NEAR(restitution<3>(NormalLaw::hertz, law, 32 * slow), collision_restitution(NormalLaw::hertz, rule, g),
                3e-3);
    EXPECT_NEAR(restitution<3>(NormalLaw::tsuji, tsuji, 32 * slow), 0.5, 2e-3);
  }
}

TEST(HertzHeadOn, peak_overlap_force_and_duration_of_an_elastic_collision) {
  EngineSetup<3> setup = head_on<3>(hertz(1, 0), slow, 1e-4, Scheme::verlet, slow * 1e-3);
  setup.kind = NormalLaw::hertz;
  Engine<3> engine(setup);
  const scenes::Impact impact = scenes::watch(engine, 13000);
  const double peak = std::pow(5 * 0.5 * slow * slow / (4 * stiffness), 0.4);
  EXPECT_NEAR(impact.deepest / peak, 1, 1e-5);
  EXPECT_NEAR(impact.strongest / (stiffness * std::pow(peak, 1.5)), 1, 1e-5);
  EXPECT_NEAR(impact.last - impact.first, 1, 5e-4)
      << "the stiffness of S2 is the one for which a collision lasts tau_c";
}

/// A body of unit diameter above a plane across the last axis.
template <int D>
EngineSetup<D> above_a_plane(const PairLaw<>& law, double height, double dt) {
  EngineSetup<D> s;
  s.radius = {0.5};
  s.mass = {1};
  s.inertia = {(D == 2 ? 0.5 : 0.4) * 0.25};
  s.position = {Vec<D>{}};
  s.position[0][D - 1] = height;
  s.velocity = {Vec<D>{}};
  s.walls = {{WallKind::plane, D - 1, false, 0.0, 0, 0, {}}};
  s.kind = NormalLaw::hertz;
  s.grain_law = s.wall_law = law;
  s.dt = dt;
  return s;
}

TEST(HertzOblique, a_sphere_slides_throughout_its_impact_on_a_plane) {
  for (const double mu : {0.05, 0.1}) {
    EngineSetup<3> s = above_a_plane<3>(hertz(1, mu), 0.5 + 1e-7, 2e-5);
    s.velocity[0] = {4 * slow, 3 * slow, -slow};
    Engine<3> engine(s);
    const Packing p = after_contact<3>(engine);
    const double change = mu * 2 * slow;
    EXPECT_NEAR(p.grains.velocity[0][2] / slow, 1, 1e-4);
    EXPECT_NEAR(p.grains.velocity[0][0] / slow, 4 - 0.8 * change / slow, 1e-4);
    EXPECT_NEAR(p.grains.velocity[0][1] / slow, 3 - 0.6 * change / slow, 1e-4);
    // I w = R mu (1 + e) m v_n, about the axis across the motion
    const double spin = 2.5 * change / 0.5;
    EXPECT_NEAR(norm(p.grains.spin[0]) / spin, 1, 1e-3);
    EXPECT_NEAR(dot(p.grains.spin[0], p.grains.velocity[0]), 0, 1e-9);
  }
}

TEST(HertzOblique, a_spinning_sphere_is_kicked_sideways) {
  EngineSetup<3> s = above_a_plane<3>(hertz(1, 0.1), 0.5 + 1e-7, 2e-5);
  s.velocity[0] = {0, 0, -slow};
  s.spin = {Vec3{0, 20 * slow, 0}};
  Engine<3> engine(s);
  const Packing p = after_contact<3>(engine);
  // v_t at the floor is w x (-R z) = -10 slow along x: friction drives the sphere towards +x
  EXPECT_NEAR(p.grains.velocity[0][0] / slow, 0.2, 1e-3);
  EXPECT_NEAR(p.grains.spin[0][1] / slow, 20 - 2.5 * 0.2 / 0.5, 1e-2);
}

/// Time and speed at which a body thrown along a floor begins to roll.
template <int D>
std::pair<double, double> slide_to_roll(double mu, double weight, double thrown) {
  const PairLaw<> law = hertz(1, mu);  // dashpots would end the sliding softly
  EngineSetup<D> s = above_a_plane<D>(law, 0.5 - std::pow(weight / law.k_n, 2.0 / 3), 1e-3);
  s.gravity[D - 1] = -weight;
  s.velocity[0][0] = thrown;
  Engine<D> engine(s);
  while (engine.step() < 10'000'000) {
    engine.run(20);
    engine.compute_forces();
    const Packing p = engine.record();
    const double slip = p.grains.velocity[0][0] + 0.5 * (D == 2 ? p.grains.spin[0][2] : -p.grains.spin[0][1]);
    if (slip < 1e-3 * thrown) return {engine.time(), p.grains.velocity[0][0]};
    engine.advance();
  }
  return {-1, -1};
}

TEST(Rolling, begins_at_five_sevenths_of_the_speed_for_a_sphere_and_two_thirds_for_a_disc) {
  constexpr double mu = 0.2, g = 0.02, u = 0.5;
  const auto [sphere_time, sphere_speed] = slide_to_roll<3>(mu, g, u);
  EXPECT_NEAR(sphere_speed / u, 5.0 / 7, 2e-3);
  EXPECT_NEAR(sphere_time / (2 * u / (7 * mu * g)), 1, 5e-3);
  const auto [disc_time, disc_speed] = slide_to_roll<2>(mu, g, u);
  EXPECT_NEAR(disc_speed / u, 2.0 / 3, 2e-3);
  EXPECT_NEAR(disc_time / (u / (3 * mu * g)), 1, 5e-3);
}

TEST(Rolling, the_ledger_counts_the_work_of_gravity) {
  EngineSetup<3> s = above_a_plane<3>(hertz(0.5, 0.3), 0.7, 1e-3);
  s.gravity = {1e-3, 0, -1e-2};
  s.velocity[0] = {0.02, 0, 0};
  Engine<3> engine(s);
  const double before = engine.kinetic_energy();
  engine.run(40000);
  engine.compute_forces();
  const EnergyLedger e = engine.record().energy;
  EXPECT_GT(e.gravity_work, 1e-3);
  EXPECT_NEAR(e.sum() - before, 0, 0.01 * e.turned_over());
}

}  // namespace
}  // namespace jam
