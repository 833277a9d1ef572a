// Packings large enough to be cut into parts: the same bits for any number of threads.
#include <gtest/gtest.h>

#include <random>

#include "bits_of.hpp"
#include "jamscape/base/flush_to_zero.hpp"
#include "jamscape/dem/engine.hpp"
#include "jamscape/protocol/driver.hpp"
#include "jamscape/protocol/start.hpp"

namespace jam {
namespace {

constexpr std::int64_t steps = 240;

struct LargeScene {
  const char* name;
  int dimension;
  WallModel walls;
  double mu;
  Scheme scheme;
  NormalLaw law = NormalLaw::linear;
};

const std::vector<LargeScene> scenes = {
    {"discs, bead walls", 2, WallModel::beads, 0.5, Scheme::gear5},
    {"discs, periodic", 2, WallModel::periodic, 0.5, Scheme::verlet},
    {"discs, flat walls, no friction", 2, WallModel::flat, 0.0, Scheme::verlet},
    {"spheres, flat walls", 3, WallModel::flat, 0.5, Scheme::verlet, NormalLaw::hertz},
    {"spheres, periodic", 3, WallModel::periodic, 0.3, Scheme::gear5}};

/// Grains on a lattice, swollen until neighbours overlap by some percent, thrown about, squeezed and pulled down.
template <int D>
Engine<D> make(const LargeScene& scene, const Kernels& kernels = best_kernels()) {
  SystemOptions s;
  s.grains.count = D == 2 ? 148 * 148 : 28 * 28 * 28;
  s.domain.dimension = D;
  s.domain.walls = scene.walls;
  s.contact.friction = scene.mu;
  s.contact.law = scene.law;
  s.contact.stiffness = 300;
  s.contact.wall_stiffness = 1;
  s.contact.impact_speed = 0.1;
  s.integrator.scheme = scene.scheme;
  s.integrator.step = 0.004;
  s.start.packing_fraction = D == 2 ? 0.7 : 0.45;
  EngineSetup<D> setup = start<D>(s, {7, "threads", 0});
  const double gap = norm(setup.position[1] - setup.position[0]);
  std::mt19937_64 random(11);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53 - 0.5; };
  for (auto& r : setup.radius) r = gap * (0.51 + 0.02 * uniform());
  for (auto& v : setup.velocity)
    for (int c = 0; c < D; ++c) v[c] = 0.6 * uniform();
  setup.gravity[D - 1] = -0.1;
  Engine<D> engine(setup, kernels);
  for (std::size_t w = 0; w < engine.walls().size(); ++w)
    engine.set_wall_velocity(w, engine.walls()[w].high ? -0.05 : 0.05);
  if (engine.walls().empty()) engine.set_box_speed(0.05);
  return engine;
}

struct End {
  Packing packing;
  Archive state;
};

template <int D>
End end_of(Engine<D>& engine) {
  End end;
  engine.save(end.state);
  engine.compute_forces();
  end.packing = engine.record();
  return end;
}

template <int D>
End run(const LargeScene& scene, int threads, const Kernels& kernels = best_kernels()) {
  Engine<D> engine = make<D>(scene, kernels);
  engine.set_threads(threads);
  engine.run(steps);
  return end_of(engine);
}

/// Not of the law: how many contacts there are between grains, found by looking at all pairs.
template <int D>
std::size_t count_overlaps(const Packing& p) {
  std::size_t found = 0;
  const std::size_t n = p.grains.size();
  std::vector<double> x[D], r = p.grains.radius;
  for (int c = 0; c < D; ++c)
    for (std::size_t k = 0; k < n; ++k) x[c].push_back(p.grains.position[k][c]);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      double r2 = 0;
      for (int c = 0; c < D; ++c) {
        double d = std::abs(x[c][j] - x[c][i]);
        if (p.domain.periodic[static_cast<std::size_t>(c)]) d = std::min(d, p.domain.hi[c] - p.domain.lo[c] - d);
        r2 += d * d;
      }
      found += r2 < (r[i] + r[j]) * (r[i] + r[j]);
    }
  return found;
}

template <int D>
void compare(const LargeScene& scene) {
  SCOPED_TRACE(scene.name);
  const FlushToZero guard;
  const End one = run<D>(scene, 1);
  const auto& counters = std::get<std::vector<std::int64_t>>(one.state.at("engine/counters"));
  EXPECT_GE(counters[4], 3) << "the list of pairs is to be made anew several times";
  EXPECT_GT(std::get<std::vector<std::int64_t>>(one.state.at("engine/group_a")).size(), 8u);
  std::size_t with_wall = 0;
  for (const auto j : one.packing.contacts.j) with_wall += j < 0;
  EXPECT_EQ(with_wall > 50, scene.walls != WallModel::periodic);
  EXPECT_GT(one.packing.contacts.size() - with_wall, one.packing.grains.size() / 2);
  EXPECT_EQ(one.packing.contacts.size() - with_wall, count_overlaps<D>(one.packing));

  for (const int threads : {2, 3, 5}) {
    const End several = run<D>(scene, threads);
    EXPECT_EQ(bits_of(several.packing), bits_of(one.packing)) << threads << " threads";
    EXPECT_EQ(several.state, one.state) << threads << " threads";
  }
  EXPECT_EQ(bits_of(run<D>(scene, 2, plain_kernels()).packing), bits_of(one.packing)) << "plain kernels";
}

TEST(Threads, the_same_bits_for_any_number) {
  for (const LargeScene& scene : scenes) scene.dimension == 2 ? compare<2>(scene) : compare<3>(scene);
}

template <int D>
void resume(const LargeScene& scene) {
  SCOPED_TRACE(scene.name);
  const FlushToZero guard;
  const End whole = run<D>(scene, 1);
  Engine<D> first = make<D>(scene);
  first.set_threads(2);
  first.run(steps / 3);
  Archive saved;
  first.save(saved);
  Engine<D> second = make<D>(scene);
  second.set_threads(3);
  second.load(saved);
  second.set_threads(2);
  second.run(steps - steps / 3);
  EXPECT_EQ(bits_of(end_of(second).packing), bits_of(whole.packing));

  saved.erase("engine/group_b");
  EXPECT_THROW(second.load(saved), std::runtime_error);
}

TEST(Threads, a_checkpoint_goes_on_with_the_same_bits_on_another_number) {
  for (const LargeScene& scene : scenes) scene.dimension == 2 ? resume<2>(scene) : resume<3>(scene);
}

TEST(Threads, those_of_use_are_told) {
  SystemOptions s;
  s.grains.count = 22000;
  EXPECT_EQ(threads_of_use(s, 4), 4);
  EXPECT_EQ(threads_of_use(s, 1000), 6);  // parts of at most 4096 discs
  EXPECT_EQ(threads_of_use(s, 0), 1);
  s.grains.count = 100;
  EXPECT_EQ(threads_of_use(s, 4), 1);
  s.stages.resize(1);
  EXPECT_EQ(make_driver(s, {})->set_threads(4), 1);
  s.grains.shape = BodyShape::cross;
  s.domain.walls = WallModel::box;
  s.domain.gravity = 1;
  s.grains.count = 30000;
  EXPECT_EQ(threads_of_use(s, 4), 1);
  s.grains.count = 10;
  EXPECT_EQ(make_driver(s, {})->set_threads(4), 1);
}

}  // namespace
}  // namespace jam
