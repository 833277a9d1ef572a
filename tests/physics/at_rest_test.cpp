// Starts at rest: walls that come to grains which do not move must find them, whatever the wall, the law, the
// dimension. Every contact there is, found by looking at all pairs, has to be in the record, and as shallow as the
// speed of the walls allows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "compression.hpp"
#include "jamscape/base/error.hpp"
#include "jamscape/dem/diverged.hpp"
#include "jamscape/protocol/simulate.hpp"
#include "two_bodies.hpp"

namespace jam {
namespace {

struct Scene {
  int dimension;
  WallModel walls;
  NormalLaw law;
};

std::vector<Scene> scenes() {
  std::vector<Scene> all;
  for (const NormalLaw law : {NormalLaw::linear, NormalLaw::ratio, NormalLaw::hertz, NormalLaw::tsuji}) {
    for (const WallModel walls : {WallModel::beads, WallModel::flat, WallModel::periodic})
      all.push_back({2, walls, law});
    for (const WallModel walls : {WallModel::flat, WallModel::periodic}) all.push_back({3, walls, law});
  }
  return all;
}

SystemOptions at_rest(const Scene& scene) {
  SystemOptions s;
  const bool flat = scene.dimension == 2;
  s.grains.count = flat ? 25 : 216;
  s.grains.width = scene.walls == WallModel::periodic ? 0.4 : 0;
  s.domain.dimension = scene.dimension;
  s.domain.walls = scene.walls;
  s.domain.area = AreaConvention::actual;
  s.contact.law = scene.law;
  s.contact.damping = DampingRule::clipped;
  s.start.speed = 0;
  s.start.packing_fraction = flat ? 0.6 : 0.4;
  s.stages = {compression("squeeze", flat ? 0.8 : 0.58, 1e-3, 12)};
  return s;
}

/// Overlaps of all pairs of grains, images included, and of all grains with all walls, above `least`.
std::size_t overlapping(const Packing& p, double least) {
  std::size_t found = 0;
  const auto count = [&](double overlap) { found += overlap > least ? 1 : 0; };
  const Grains& g = p.grains;
  for (std::size_t a = 0; a < g.size(); ++a) {
    for (std::size_t b = a + 1; b < g.size(); ++b) {
      Vec3 d = g.position[b] - g.position[a];
      for (int c = 0; c < p.dimension; ++c) {
        const double length = p.domain.hi[c] - p.domain.lo[c];
        if (p.domain.periodic[static_cast<std::size_t>(c)]) d[c] -= length * std::round(d[c] / length);
      }
      count(g.radius[a] + g.radius[b] - norm(d));
    }
    for (const Wall& w : p.walls) {
      if (w.kind == WallKind::plane) count(g.radius[a] - dot(w.normal, g.position[a] - w.position));
      for (const Vec3& bead : w.beads) count(g.radius[a] + w.bead_radius - norm(g.position[a] - bead));
    }
  }
  return found;
}

TEST(AtRest, walls_find_grains_that_do_not_move) {
  for (const Scene& scene : scenes()) {
    const std::string where = std::to_string(scene.dimension) + "D, walls " +
                              std::to_string(static_cast<int>(scene.walls)) + ", law " +
                              std::to_string(static_cast<int>(scene.law));
    std::size_t frames = 0, contacts = 0, on_walls = 0;
    double deepest = 0;
    Hooks hooks;
    hooks.frame = [&](std::size_t, const Packing& p) {
      ++frames;
      contacts = p.contacts.size();
      on_walls = static_cast<std::size_t>(
          std::count_if(p.contacts.j.begin(), p.contacts.j.end(), [](auto j) { return j < 0; }));
      for (const double x : p.contacts.overlap) deepest = std::max(deepest, x);
      EXPECT_EQ(overlapping(p, 1e-9),
                std::count_if(p.contacts.overlap.begin(), p.contacts.overlap.end(), [](double x) { return x > 1e-9; }))
          << where << ", frame " << frames;
    };
    ASSERT_EQ(simulate(at_rest(scene), {3, "at rest", 0}, hooks), Outcome::finished) << where;
    EXPECT_EQ(frames, 12u);
    EXPECT_GT(contacts, 0u) << where;
    EXPECT_EQ(on_walls > 0, scene.walls != WallModel::periodic) << where;
    EXPECT_LT(deepest, 0.15) << where;
  }
}

/// A grain, a plane that comes to it at `speed`, and one behind it.
template <int D>
EngineSetup<D> between_planes(double speed, NormalLaw law) {
  EngineSetup<D> s = scenes::head_on<D>(scenes::s1_law(0.5, 0.5), 0, 0.01, Scheme::verlet);
  s.kind = law;
  s.radius.resize(1), s.mass.resize(1), s.inertia.resize(1), s.position.resize(1), s.velocity.resize(1);
  s.walls = {{WallKind::plane, 0, false, -0.9, speed, 0, {}, {}}, {WallKind::plane, 0, true, 0.9, 0, 0, {}, {}}};
  return s;
}

TEST(AtRest, a_plane_touches_at_the_step_it_arrives) {
  for (const NormalLaw law : {NormalLaw::linear, NormalLaw::hertz})
    for (const double speed : {1e-4, 1e-2, 1.0}) {
      Engine<2> disc(between_planes<2>(speed, law));
      Engine<3> sphere(between_planes<3>(speed, law));
      const auto arrival = [&](auto& engine) {
        for (std::int64_t k = 0; k < 1000000; ++k) {
          engine.compute_forces();
          const Packing p = engine.record();
          if (p.contacts.size() > 0) {
            EXPECT_LT(p.contacts.overlap[0], 1.01 * speed * 0.01);
            return engine.time();
          }
          engine.advance();
        }
        return -1.0;
      };
      EXPECT_NEAR(arrival(disc), 0.4 / speed, 0.011);
      EXPECT_NEAR(arrival(sphere), 0.4 / speed, 0.011);
    }
}

// Two wall forces that cancel: the sum is nothing, and what it may be off by is round-off of the forces.
TEST(AtRest, a_grain_squeezed_between_planes_passes_its_own_balance) {
  Engine<3> sphere(between_planes<3>(1e-3, NormalLaw::linear));
  for (int k = 0; k < 90; ++k) {
    sphere.run(1000);
    sphere.compute_forces();
    EXPECT_NO_THROW(sphere.record()) << k;
    sphere.advance();
  }
}

/// What the engine says of a grain at x between planes at 0 and 10.
template <int D>
std::string verdict(double x, WallKind kind) {
  EngineSetup<D> s = scenes::head_on<D>(scenes::s1_law(0.5, 0), 0, 0.01, Scheme::verlet);
  s.position[0] = s.position[1] = Vec<D>{5, 5};
  s.position[1][0] = 7;
  for (int axis = 0; axis < D; ++axis)
    for (const bool high : {false, true}) {
      EngineWall<D> wall{kind, axis, high, high ? 10.0 : 0.0, 0, 0.5, {}, {}};
      if (kind == WallKind::beads)
        for (int b = -2; b < 13; ++b) {
          Vec<D> at{};
          at[axis] = wall.position, at[1 - axis] = b;
          wall.beads.push_back(at);
        }
      s.walls.push_back(wall);
    }
  Engine<D> engine(s);
  engine.run(10);
  s.position[1][0] = x;
  try {
    Engine<D> moved(s);
    moved.compute_forces();
    moved.record();
  } catch (const Diverged& e) {
    return e.what();
  }
  return "";
}

TEST(AtRest, a_grain_outside_its_box_is_named) {
  for (const std::string& said :
       {verdict<2>(20021, WallKind::plane), verdict<3>(20021, WallKind::plane), verdict<2>(20021, WallKind::beads)}) {
    EXPECT_NE(said.find("grain 1 at (20021.0"), std::string::npos) << said;
    EXPECT_NE(said.find("outside its box"), std::string::npos) << said;
    EXPECT_NE(said.find("x = 10"), std::string::npos) << said;
  }
  EXPECT_NE(verdict<2>(-0.01, WallKind::plane).find("lower wall at x = 0"), std::string::npos);
  EXPECT_EQ(verdict<2>(9.4, WallKind::plane), "");
  EXPECT_EQ(verdict<2>(8.9, WallKind::beads), "");
}

}  // namespace
}  // namespace jam
