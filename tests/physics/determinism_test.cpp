// The same bits whatever the vector width, and after a stop and a restart.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "bits_of.hpp"
#include "compression.hpp"
#include "jamscape/base/flush_to_zero.hpp"
#include "jamscape/base/random.hpp"
#include "jamscape/protocol/plan.hpp"
#include "jamscape/protocol/simulate.hpp"
#include "jamscape/protocol/start.hpp"
#include "two_bodies.hpp"

namespace jam {
namespace {

SystemOptions scene(int dimension, WallModel walls, double mu, Scheme scheme) {
  SystemOptions s;
  s.grains.count = dimension == 2 ? 196 : 216;
  s.domain.dimension = dimension;
  s.domain.walls = walls;
  s.contact.friction = mu;
  s.integrator.scheme = scheme;
  s.start.packing_fraction = dimension == 2 ? 0.7 : 0.5;
  s.stages = {compression("squeeze", dimension == 2 ? 0.85 : 0.62, 1e-2, 6)};
  return s;
}

std::vector<SystemOptions> scenes_to_compare() {
  std::vector<SystemOptions> all = {
      scene(2, WallModel::beads, 0.5, Scheme::gear5),     scene(2, WallModel::beads, 0.0, Scheme::verlet),
      scene(2, WallModel::periodic, 0.5, Scheme::verlet), scene(2, WallModel::flat, 0.5, Scheme::verlet),
      scene(3, WallModel::flat, 0.5, Scheme::verlet),     scene(3, WallModel::periodic, 0.3, Scheme::gear5)};
  for (const NormalLaw law : {NormalLaw::hertz, NormalLaw::tsuji})
    for (const double mu : {0.0, 0.5}) {
      SystemOptions s = scene(law == NormalLaw::hertz ? 3 : 2, WallModel::flat, mu, Scheme::verlet);
      s.contact.law = law;
      s.contact.damping = DampingRule::clipped;
      s.contact.stiffness = 300;
      s.contact.impact_speed = 0.1;
      s.contact.wall_stiffness = 2;
      s.integrator.step = 0.004;
      s.stages[0].speed = 5e-2;
      all.push_back(s);
    }
  return all;
}

template <int D>
std::uint64_t run_with(const Kernels& kernels, const SystemOptions& s) {
  Engine<D> engine(start<D>(s, {5, "bits", 0}), kernels);
  for (std::size_t w = 0; w < engine.walls().size(); ++w)
    engine.set_wall_velocity(w, engine.walls()[w].high ? -s.stages[0].speed : s.stages[0].speed);
  if (engine.walls().empty()) engine.set_box_speed(s.stages[0].speed);
  engine.run(timetable(s, {5, "bits", 0}).plan.steps);
  engine.compute_forces();
  const Packing p = engine.record();
  EXPECT_GT(p.contacts.size(), p.grains.size());
  return bits_of(p);
}

TEST(Determinism, every_vector_width_gives_the_bits_of_the_plain_kernel) {
  for (const SystemOptions& s : scenes_to_compare()) {
    const auto run = [&](const Kernels& k) { return s.domain.dimension == 2 ? run_with<2>(k, s) : run_with<3>(k, s); };
    const std::uint64_t plain = run(plain_kernels());
    for (const Kernels* wide : available_kernels().subspan(1)) EXPECT_EQ(run(*wide), plain) << wide->name;
  }
}

TEST(Determinism, a_stopped_and_resumed_run_gives_the_bits_of_one_never_stopped) {
  for (const SystemOptions& s : scenes_to_compare()) {
    const TaskKey key{5, "resume", 2};
    std::vector<std::uint64_t> whole, pieces;
    Hooks hooks;
    hooks.largest_ledger_error = 1e9;  // the bits matter here, not the physics
    hooks.frame = [&](std::size_t, const Packing& p) { whole.push_back(bits_of(p)); };
    ASSERT_EQ(simulate(s, key, hooks), Outcome::finished);

    Archive saved;
    int stops = 0;
    hooks.frame = [&](std::size_t index, const Packing& p) {
      EXPECT_EQ(index, pieces.size());
      pieces.push_back(bits_of(p));
    };
    hooks.look_every = 1777;
    hooks.stop = [&] { return true; };  // at every look
    hooks.checkpoint = [&](const Archive& a) { saved = a; };
    Outcome outcome = simulate(s, key, hooks);
    for (; outcome == Outcome::stopped; ++stops) outcome = simulate(s, key, hooks, &saved);
    EXPECT_GE(stops, 2);
    EXPECT_EQ(whole, pieces);
    EXPECT_EQ(whole.size(), 6u);
  }
}

/// The rows after many integration passes, in which a body is pushed now and then and flies freely in between.
template <int D>
std::vector<double> integrate(const Kernels& kernels, Scheme scheme, bool few_pushed) {
  const FlushToZero flush;
  constexpr std::size_t count = 50;
  Bodies<D> bodies;
  bodies.resize(count, 0, 1, true);
  Random random(3, "passes", 0, "pushes");
  for (double& x : bodies.rows) x = random.uniform() - 0.5;
  for (double& q : bodies.inverse) q = 1 + random.uniform();
  constexpr std::size_t per_motion = 4;
  for (std::size_t c = 3; c < bodies.rows.size(); c += per_motion)
    if (c % Row<D>::stride != Row<D>::radius) bodies.rows[c] = 0;
  BodyArrays b{bodies.rows.data(),
               bodies.forces.data(),
               bodies.inverse.data(),
               bodies.derivatives.data(),
               bodies.calm.data(),
               count,
               0.02,
               few_pushed,
               {}};
  for (int step = 0; step < 500; ++step) {
    for (std::size_t k = 0; k < count; ++k) {
      if (random.uniform() > 0.01) continue;
      for (std::size_t c = 0; c < Row<D>::force_stride; ++c)
        if (c % per_motion != 3) bodies.forces[k * Row<D>::force_stride + c] = random.uniform() - 0.5;
    }
    (scheme == Scheme::gear5 ? kernels.gear<D>() : kernels.verlet<D>())(b);
  }
  std::vector<double> all(bodies.rows.begin(), bodies.rows.end());
  all.insert(all.end(), std::begin(b.fastest), std::end(b.fastest));
  if (scheme == Scheme::gear5 && few_pushed) {
    const auto calm = std::count(bodies.calm.begin(), bodies.calm.end(), 1);
    EXPECT_GT(calm, 10);
    EXPECT_LT(calm, 45);
  }
  return all;
}

TEST(Determinism, leaving_out_what_zero_forces_do_not_change_changes_no_bit) {
  const auto bits = [](const std::vector<double>& v) {
    std::vector<std::uint64_t> b(v.size());
    std::memcpy(b.data(), v.data(), v.size() * sizeof(double));
    return b;
  };
  for (const Kernels* kernels : available_kernels())
    for (const Scheme scheme : {Scheme::verlet, Scheme::gear5}) {
      EXPECT_EQ(bits(integrate<2>(*kernels, scheme, true)), bits(integrate<2>(*kernels, scheme, false)));
      EXPECT_EQ(bits(integrate<3>(*kernels, scheme, true)), bits(integrate<3>(*kernels, scheme, false)));
    }
}

TEST(Determinism, a_checkpoint_of_another_task_is_refused) {
  const SystemOptions s = scenes_to_compare()[0];
  Archive saved;
  Hooks hooks;
  hooks.look_every = 100;
  hooks.stop = [] { return true; };
  hooks.checkpoint = [&](const Archive& a) { saved = a; };
  simulate(s, {5, "mine", 0}, hooks);
  EXPECT_THROW(simulate(s, {5, "mine", 1}, {}, &saved), std::runtime_error);
  EXPECT_THROW(simulate(s, {5, "other", 0}, {}, &saved), std::runtime_error);
  saved.erase("engine/pair_i");
  EXPECT_THROW(simulate(s, {5, "mine", 0}, {}, &saved), std::runtime_error);
}

TEST(Divergence, too_long_a_step_is_stopped_with_step_and_grain) {
  SystemOptions s = scene(2, WallModel::beads, 0.5, Scheme::verlet);
  s.contact.stiffness = 1e5;
  s.integrator.step = 0.1;
  try {
    simulate(s, {1, "wild", 0}, {});
    FAIL() << "nothing was noticed";
  } catch (const Diverged& e) {
    EXPECT_NE(std::string(e.what()).find("step "), std::string::npos);
    EXPECT_NE(std::string(e.what()).find("grain "), std::string::npos);
    EXPECT_NE(std::string(e.what()).find("is too long"), std::string::npos);
  }
}

}  // namespace
}  // namespace jam
