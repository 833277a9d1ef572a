// Asking an engine for forces, records and energies changes no bit of what follows, nor of its ledger; and a checkpoint
// may be taken at any instant.
#include <gtest/gtest.h>

#include "cluster_scenes.hpp"
#include "jamscape/base/flush_to_zero.hpp"
#include "jamscape/base/random.hpp"
#include "jamscape/protocol/start.hpp"

namespace jam {
namespace {

constexpr int steps = 900;

struct BallScene {
  int dimension;
  WallModel walls;
  Scheme scheme;
  NormalLaw law = NormalLaw::linear;
  SpringTurn turn = SpringTurn::projected;
};

template <int D>
EngineSetup<D> setup_of(const BallScene& scene) {
  SystemOptions s;
  s.grains.count = D == 2 ? 100 : 125;
  s.domain.dimension = D;
  s.domain.walls = scene.walls;
  s.domain.gravity = scene.walls == WallModel::periodic ? 0 : 0.02;
  s.contact.law = scene.law;
  s.contact.stiffness = 20;
  s.contact.spring_turn = scene.turn;
  s.integrator.scheme = scene.scheme;
  s.integrator.step = 0.01;
  s.start.packing_fraction = D == 2 ? 0.65 : 0.45;
  s.start.speed = 0.2;
  return start<D>(s, {3, "asking", 0});
}

template <int D>
void close_in(Engine<D>& engine) {
  for (std::size_t w = 0; w < engine.walls().size(); ++w)
    engine.set_wall_velocity(w, engine.walls()[w].high ? -0.03 : 0.03);
  if (engine.walls().empty()) engine.set_box_speed(0.03);
}
void close_in(ClusterEngine& engine) { engine.set_wall_velocity(engine.walls().size() - 1, -0.02); }

template <class Engine>
Archive state_of(const Engine& engine) {
  Archive state;
  engine.save(state);
  return state;
}

template <class Engine, class Setup>
void ask_at_random(const Setup& setup) {
  const FlushToZero guard;
  Engine left_alone(setup), asked(setup);
  close_in(left_alone), close_in(asked);
  Random random(1, "asking", 0, "questions");
  std::size_t contacts = 0;
  for (int k = 0; k < steps; ++k) {
    for (std::uint64_t questions = random.below(4); questions > 0; --questions) switch (random.below(5)) {
        case 0:
          asked.compute_forces();
          break;
        case 1:
          contacts = std::max(contacts, asked.record().contacts.size());
          break;
        case 2:
          EXPECT_GE(asked.kinetic_energy(), 0);
          break;
        case 3:
          EXPECT_GE(asked.elastic_energy().normal, 0);
          break;
        default: {
          Engine another(setup);
          another.load(state_of(asked));
          asked = std::move(another);
        }
      }
    k % 2 ? asked.advance() : asked.run(1);
  }
  left_alone.run(steps);
  EXPECT_GT(contacts, 20u);
  EXPECT_EQ(asked.step(), steps);
  EXPECT_EQ(state_of(asked), state_of(left_alone));
  const Packing a = asked.record(), b = left_alone.record();
  EXPECT_EQ(a.contacts.normal_force, b.contacts.normal_force);
  for (const auto member : {&EnergyLedger::kinetic, &EnergyLedger::elastic, &EnergyLedger::damped,
                            &EnergyLedger::rubbed, &EnergyLedger::wall_work, &EnergyLedger::gravity_work})
    EXPECT_EQ(a.energy.*member, b.energy.*member);
  EXPECT_EQ(state_of(asked), state_of(left_alone));
  for (std::size_t w = 0; w < a.walls.size(); ++w) EXPECT_EQ(a.walls[w].force[1], b.walls[w].force[1]);
}

TEST(Asking, changes_no_bit_of_balls) {
  for (const BallScene& scene :
       std::vector<BallScene>{{2, WallModel::beads, Scheme::gear5},
                              {2, WallModel::flat, Scheme::verlet, NormalLaw::hertz},
                              {2, WallModel::periodic, Scheme::verlet},
                              {3, WallModel::flat, Scheme::verlet, NormalLaw::linear, SpringTurn::twirled},
                              {3, WallModel::periodic, Scheme::gear5}})
    scene.dimension == 2 ? ask_at_random<Engine<2>>(setup_of<2>(scene)) : ask_at_random<Engine<3>>(setup_of<3>(scene));
}

/// Bodies that fall in a box under a lid.
ClusterSetup fall(const ClusterShape& shape, bool planar, NormalLaw law, DuplicateRule duplicates, double above = 0) {
  ClusterSetup s;
  s.shapes = {shape};
  s.density = 1 / shape.volume;
  s.planar = planar;
  s.duplicates = duplicates;
  s.kind = law;
  s.grain_law = s.wall_law = scenes::s3_law(0.2, 0.4);
  s.gravity = {0, -0.01, 0};
  s.dt = 0.05;
  Random random(4, "asking", 0, "bodies");
  const double pitch = 2 * shape.circumradius + 0.02;
  const int across = 4, deep = planar ? 1 : 3, layers = 4;
  for (int y = 0; y < layers; ++y)
    for (int x = 0; x < across; ++x)
      for (int z = 0; z < deep; ++z) {
        s.bodies.shape.push_back(0);
        s.bodies.position.push_back({(x + 0.5) * pitch, (y + 0.5) * pitch, planar ? 0 : (z + 0.5) * pitch});
        s.bodies.velocity.push_back({random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), 0});
        s.bodies.orientation.push_back(planar ? scenes::turn_about({0, 0, 1}, 6 * random.uniform())
                                              : scenes::random_turn(random));
      }
  const auto plane = [&](int axis, double high) {
    s.walls.push_back({.axis = axis, .high = false, .position = 0});
    s.walls.push_back({.axis = axis, .high = true, .position = high});
  };
  plane(0, across * pitch);
  if (!planar) plane(2, deep * pitch);
  plane(1, layers * pitch + above);
  return s;
}

TEST(Asking, changes_no_bit_of_clusters) {
  ask_at_random<ClusterEngine>(fall(cross_shape(3), true, NormalLaw::ratio, DuplicateRule::literal));
  ask_at_random<ClusterEngine>(fall(star_shape(2), false, NormalLaw::linear, DuplicateRule::literal));
  ask_at_random<ClusterEngine>(fall(star_shape(1.2), false, NormalLaw::hertz, DuplicateRule::merge));
}

TEST(Asking, bodies_may_join_at_any_instant) {
  const ClusterSetup setup = fall(cross_shape(3), true, NormalLaw::ratio, DuplicateRule::literal, 4);
  ClusterEngine asked(setup);
  asked.run(50);
  ClusterBodies one;
  one.shape = {0};
  one.position = {{asked.walls()[1].position / 2, asked.walls()[3].position - 2, 0}};
  one.velocity = {{0.1, 0, 0}};
  const Packing before = asked.record();
  asked.add(one);
  const Packing after = asked.record();
  ASSERT_EQ(after.grains.size(), before.grains.size() + 1);
  EXPECT_EQ(after.energy.gravity_work, before.energy.gravity_work);
  EXPECT_EQ(after.energy.wall_work, before.energy.wall_work);
  EXPECT_EQ(after.energy.damped, before.energy.damped);
  EXPECT_NEAR(after.grains.velocity.back()[0], 0.1, 1e-15);
  EXPECT_NEAR(after.energy.kinetic - before.energy.kinetic, 0.5 * after.grains.mass.back() * 0.01, 1e-12);
}

}  // namespace
}  // namespace jam
