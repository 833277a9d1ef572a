// A pair of spheres that turns about its own normal: its tangential spring stays where it was in the world, or turns
// along.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compression.hpp"
#include "jamscape/base/error.hpp"
#include "jamscape/protocol/simulate.hpp"
#include "jamscape/protocol/start.hpp"
#include "two_bodies.hpp"

namespace jam {
namespace {

/// Two heavy spheres in contact along x, the second of which has slipped along y; then both spin about x at `w`. The
/// tangential force on the first before and after a time `t`.
std::array<Vec3, 2> before_and_after(SpringTurn turn, double w, double t, double dt, bool wall = false) {
  EngineSetup<3> s = scenes::head_on<3>(scenes::s1_law(1, 1e6), 0, dt, Scheme::verlet, -0.01);
  s.mass = {1e12, 1e12}, s.inertia = {1e12, 1e12};
  s.spring_turn = turn;
  if (wall) {
    s.position[1][0] = -3;
    s.walls = {{WallKind::plane, 0, true, 0.49, 0, 0, {}, {}}};
  }
  Engine<3> engine(s);
  Archive state;
  engine.compute_forces();
  engine.advance();
  engine.save(state);
  auto& rows = std::get<std::vector<double>>(state["engine/rows"]);
  const auto set = [&](std::size_t at, double value) {
    for (const std::size_t body : {0, 1}) rows[body * Row<3>::stride + at] = value;
  };
  rows[Row<3>::velocity + 1] = 1e-3 / dt;  // one slips by 1e-3 in a step
  if (wall) set(Row<3>::velocity + 1, 1e-3 / dt);
  engine.load(state);
  engine.compute_forces();
  engine.save(state);
  for (std::size_t c = 0; c < 3; ++c) set(Row<3>::velocity + c, 0);
  set(Row<3>::spin, w);
  engine.load(state);
  const auto force = [&] {
    engine.compute_forces();
    const Packing p = engine.record();
    EXPECT_EQ(p.contacts.size(), 1u);
    engine.advance();
    return p.contacts.tangential_force[0];
  };
  std::array<Vec3, 2> found{};
  found[0] = force();
  const auto steps = static_cast<std::int64_t>(std::llround(t / dt));
  engine.run(steps - 1);
  found[1] = force();
  return found;
}

double angle(const Vec3& a, const Vec3& b) {
  return std::acos(dot(a, b) / (norm(a) * norm(b))) * 180 / std::numbers::pi;
}

TEST(Twirl, a_spring_turns_by_90_degrees_in_a_quarter_turn_of_the_pair) {
  const double w = 0.01, quarter = std::numbers::pi / 2 / w;
  const auto turned = before_and_after(SpringTurn::twirled, w, quarter, 0.01);
  EXPECT_NEAR(norm(turned[0]), 0.8 * std::numbers::pi * std::numbers::pi / 2 * 1e-3, 1e-5);
  EXPECT_NEAR(angle(turned[0], turned[1]), 90, 0.01);
  EXPECT_NEAR(norm(turned[1]), norm(turned[0]), 1e-6 * norm(turned[0]));
  EXPECT_GT(cross(turned[0], turned[1])[0], 0) << "about +x";
  const auto kept = before_and_after(SpringTurn::projected, w, quarter, 0.01);
  EXPECT_NEAR(angle(kept[0], kept[1]), 0, 1e-4);
}

TEST(Twirl, a_wall_does_not_spin) {
  const double w = 0.01, quarter = std::numbers::pi / 2 / w;
  const auto turned = before_and_after(SpringTurn::twirled, w, quarter, 0.01, true);
  EXPECT_NEAR(angle(turned[0], turned[1]), 45, 0.01);
}

TEST(Twirl, is_for_spheres_and_keeps_the_ledger) {
  SystemOptions s;
  s.domain.walls = WallModel::flat;
  s.contact.spring_turn = SpringTurn::twirled;
  EXPECT_THROW(check_start(s), Error);
  s.domain.dimension = 3;
  s.grains.count = 125;
  s.start.packing_fraction = 0.4;
  s.integrator.step = 0.005;
  s.stages = {compression("squeeze", 0.64, 5e-3, 5)};
  std::vector<EnergyLedger> ledgers;
  Hooks hooks;
  hooks.frame = [&](std::size_t, const Packing& p) { ledgers.push_back(p.energy); };
  ASSERT_EQ(simulate(s, {1, "twirl", 0}, hooks), Outcome::finished);
  EXPECT_LT(std::abs(ledgers.back().sum() - ledgers[0].sum()), 0.01 * ledgers.back().turned_over());
}

// A sliding contact without a spring: what friction takes is the power of the dashpot as it is cut.
TEST(Springless, the_ledger_of_a_sliding_contact_closes) {
  for (const int dimension : {2, 3})
    for (const NormalLaw law : {NormalLaw::linear, NormalLaw::ratio}) {
      SystemOptions s;
      s.grains.count = dimension == 2 ? 100 : 125;
      s.domain.dimension = dimension;
      s.domain.walls = WallModel::flat;
      s.contact.law = law;
      s.contact.tangential_stiffness = 0;
      if (law == NormalLaw::ratio) s.contact.damping_ratio = 0.2;  // of the springs: none is left tangentially
      s.integrator.step = 0.002;
      s.start.packing_fraction = dimension == 2 ? 0.6 : 0.4;
      s.stages = {compression("squeeze", dimension == 2 ? 0.86 : 0.64, 5e-3, 5)};
      std::vector<EnergyLedger> ledgers;
      Hooks hooks;
      hooks.frame = [&](std::size_t, const Packing& p) { ledgers.push_back(p.energy); };
      ASSERT_EQ(simulate(s, {1, "springless", 0}, hooks), Outcome::finished);
      EXPECT_LT(std::abs(ledgers.back().sum() - ledgers[0].sum()), 0.01 * ledgers.back().turned_over()) << dimension;
      EXPECT_EQ(ledgers.back().rubbed > 0, law == NormalLaw::linear) << "the law of S3 has no dashpot without a spring";
    }
}

}  // namespace
}  // namespace jam
