// Momentum to round-off, energy to the integrator's order, the record against itself.
#include <gtest/gtest.h>

#include "compression.hpp"
#include "jamscape/base/random.hpp"
#include "jamscape/protocol/simulate.hpp"
#include "jamscape/protocol/start.hpp"
#include "two_bodies.hpp"

namespace jam {
namespace {

SystemOptions periodic(int dimension, std::int64_t count, double mu) {
  SystemOptions s;
  s.grains.count = count;
  s.grains.inertia_factor = dimension == 2 ? 0.5 : 0.4;
  s.domain.dimension = dimension;
  s.domain.walls = WallModel::periodic;
  s.contact.friction = mu;
  s.start.packing_fraction = dimension == 2 ? 0.7 : 0.4;
  s.start.speed = 0.2;
  return s;
}

template <int D>
void expect_momentum_kept(Scheme scheme) {
  SystemOptions options = periodic(D, D == 2 ? 400 : 343, 0.5);
  options.integrator.scheme = scheme;
  const EngineSetup<D> setup = start<D>(options, {7, "momentum", 0});
  Engine<D> engine(setup);
  auto momentum = [&] {
    engine.compute_forces();
    const Packing p = engine.record();
    Vec3 sum{};
    for (std::size_t k = 0; k < p.grains.size(); ++k) sum += p.grains.mass[k] * p.grains.velocity[k];
    engine.advance();
    return sum;
  };
  const Vec3 before = momentum();
  engine.run(5000);
  const Vec3 after = momentum();
  for (int c = 0; c < D; ++c) EXPECT_NEAR(after[c], before[c], 1e-11);
}

TEST(Momentum, kept_to_round_off) {
  expect_momentum_kept<2>(Scheme::verlet);
  expect_momentum_kept<2>(Scheme::gear5);
  expect_momentum_kept<3>(Scheme::verlet);
}

// With the lever arm at the contact point the torques of a contact balance the couple of its forces.
TEST(Momentum, angular_momentum_with_the_lever_at_the_contact_point) {
  ContactOptions o;
  o.lever = LeverArm::contact_point;
  auto s = scenes::head_on<2>(grain_law(o, 1.0), 0.1, 0.001, Scheme::verlet);
  s.velocity[0][1] = 0.05;
  Engine<2> engine(s);
  auto angular = [](const Packing& p) {
    double l = 0;
    for (std::size_t k = 0; k < 2; ++k)
      l += p.grains.mass[k] *
               (p.grains.position[k][0] * p.grains.velocity[k][1] - p.grains.position[k][1] * p.grains.velocity[k][0]) +
           0.125 * p.grains.spin[k][2];
    return l;
  };
  engine.compute_forces();
  const double before = angular(engine.record());
  engine.advance();
  EXPECT_NEAR(angular(scenes::after_contact<2>(engine)), before, 1e-14);
}

/// Largest drift of the ledger over a frictional compression between bead walls, against the energy turned over.
double ledger_drift(Scheme scheme, double dt, double mu, NormalLaw law = NormalLaw::linear, int dimension = 2) {
  SystemOptions s;
  s.grains.count = dimension == 2 ? 100 : 125;
  s.domain.dimension = dimension;
  if (dimension == 3) s.domain.walls = WallModel::flat;
  if (law != NormalLaw::linear) s.contact.stiffness = 300, s.contact.impact_speed = 0.1;
  s.contact.law = law;
  s.contact.friction = mu;
  s.integrator.scheme = scheme;
  s.integrator.step = dt;
  s.start.packing_fraction = dimension == 2 ? 0.6 : 0.4;
  s.stages = {compression("squeeze", dimension == 2 ? 0.86 : 0.64, 5e-3, 20)};
  std::vector<EnergyLedger> ledgers;
  Hooks hooks;
  hooks.frame = [&](std::size_t, const Packing& p) { ledgers.push_back(p.energy); };
  simulate(s, {1, "ledger", 0}, hooks);
  double drift = 0;
  for (const auto& e : ledgers) drift = std::max(drift, std::abs(e.sum() - ledgers[0].sum()));
  const EnergyLedger& end = ledgers.back();
  return drift / (end.damped + end.rubbed + end.wall_work);
}

TEST(Energy, the_ledger_closes_to_first_order_in_the_step) {
  for (const double mu : {0.0, 0.5})
    for (const Scheme scheme : {Scheme::verlet, Scheme::gear5}) {
      const double coarse = ledger_drift(scheme, 0.02, mu), fine = ledger_drift(scheme, 0.002, mu);
      EXPECT_LT(coarse, 0.03);
      EXPECT_LT(fine, 0.005);
      EXPECT_LT(fine, coarse / 3);
    }
}

TEST(Energy, the_ledger_of_the_hertz_laws_closes_too) {
  for (const NormalLaw law : {NormalLaw::hertz, NormalLaw::tsuji})
    for (const int dimension : {2, 3}) {
      const double coarse = ledger_drift(Scheme::verlet, 0.004, 0.5, law, dimension),
                   fine = ledger_drift(Scheme::verlet, 0.001, 0.5, law, dimension);
      EXPECT_LT(coarse, 0.03);
      EXPECT_LT(fine, 0.005);
    }
}

TEST(Energy, a_step_too_long_for_the_damping_is_stopped_by_the_ledger) {
  SystemOptions s;
  s.grains.count = 100;
  s.domain.walls = WallModel::flat;
  s.contact.law = NormalLaw::hertz;
  s.contact.stiffness = 485.65;
  s.contact.impact_speed = 3.66e-4;
  s.contact.damping = DampingRule::clipped;
  s.stages = {compression("squeeze", 0.88, 5e-3, 20)};
  try {
    simulate(s, {1, "stiff", 0}, {});
    FAIL() << "nothing was noticed";
  } catch (const Diverged& e) {
    EXPECT_NE(std::string(e.what()).find("energy ledger"), std::string::npos) << e.what();
  }
}

TEST(Energy, an_undamped_frictionless_gas_keeps_its_energy) {
  SystemOptions options = periodic(2, 400, 0.0);
  options.contact.restitution = 1;
  options.integrator.step = 0.002;
  Engine<2> engine(start<2>(options, {3, "gas", 0}));
  engine.compute_forces();
  const double before = engine.record().energy.sum();
  engine.advance();
  engine.run(20000);
  engine.compute_forces();
  EXPECT_NEAR(engine.record().energy.sum() / before, 1.0, 1e-4);
}

TEST(Walls, closing_beads_shrink_with_the_box_and_the_ledger_still_closes) {
  for (const BeadRows rows : {BeadRows::closing, BeadRows::framed}) {
    SystemOptions s;
    s.grains.count = 100;
    s.domain.bead_rows = rows;
    s.integrator.step = 0.005;
    s.stages = {compression("squeeze", 0.86, 5e-3, 10)};
    std::vector<EnergyLedger> ledgers;
    std::vector<double> spacing;
    Hooks hooks;
    hooks.frame = [&](std::size_t, const Packing& p) {
      ledgers.push_back(p.energy);
      for (const Wall& w : p.walls) {
        const double length = p.domain.hi[0] - p.domain.lo[0];
        spacing.push_back(norm(w.beads[1] - w.beads[0]) / length);
      }
    };
    simulate(s, {1, "closing", 0}, hooks);
    for (const double a : spacing) EXPECT_NEAR(a, spacing[0], 1e-9);
    const EnergyLedger& end = ledgers.back();
    for (const auto& e : ledgers)
      EXPECT_NEAR(e.sum(), ledgers[0].sum(), 0.01 * (end.damped + end.rubbed + end.wall_work));
  }
}

TEST(Record, forces_on_walls_and_grains_balance) {
  SystemOptions s;
  s.grains.count = 100;
  for (const WallModel walls : {WallModel::beads, WallModel::flat}) {
    s.domain.walls = walls;
    s.stages = {compression("squeeze", 0.84, 5e-3, 2)};
    Hooks hooks;
    hooks.frame = [&](std::size_t, const Packing& p) {
      Vec3 on_walls{}, from_contacts{};
      for (const Wall& w : p.walls) on_walls += w.force;
      for (std::size_t k = 0; k < p.contacts.size(); ++k) {
        EXPECT_GT(p.contacts.overlap[k], 0);
        EXPECT_NEAR(norm(p.contacts.normal[k]), 1, 1e-12);
        EXPECT_NEAR(dot(p.contacts.normal[k], p.contacts.tangential_force[k]), 0, 1e-12);
        if (p.contacts.j[k] >= 0) {
          EXPECT_LT(p.contacts.i[k], static_cast<std::uint32_t>(p.contacts.j[k]));
        } else {
          from_contacts += p.contacts.normal_force[k] * p.contacts.normal[k] - p.contacts.tangential_force[k];
        }
      }
      for (int c = 0; c < 2; ++c) EXPECT_NEAR(on_walls[c], from_contacts[c], 1e-11);
    };
    simulate(s, {1, "walls", 0}, hooks);
  }
}

}  // namespace
}  // namespace jam
