// The engine of clusters against itself and against that of spheres.
#include <gtest/gtest.h>

#include "cluster_scenes.hpp"
#include "jamscape/base/error.hpp"
#include "jamscape/dem/engine.hpp"

namespace jam {
namespace {

/// Bodies in a box, thrown about and falling.
ClusterSetup crowd(const std::vector<ClusterShape>& shapes, int side, bool planar, DuplicateRule duplicates,
                   bool spread = true) {
  Random random(5, "crowd", static_cast<std::uint64_t>(side), "scene");
  ClusterSetup s;
  s.shapes = shapes;
  s.planar = planar;
  s.duplicates = duplicates;
  double reach = 0, volume = 0;
  for (const ClusterShape& shape : shapes) {
    reach = std::max(reach, shape.circumradius);
    volume = std::max(volume, shape.volume);
  }
  s.density = 1 / volume;
  const double pitch = 2.3 * reach, width = pitch * side;
  for (int z = 0; z < (planar ? 1 : side); ++z)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        s.bodies.shape.push_back(static_cast<std::int32_t>(random.below(shapes.size())));
        s.bodies.scale.push_back(spread ? random.uniform(0.8, 1.1) : 1.0);
        s.bodies.position.push_back({(x + 0.5) * pitch, (y + 0.5) * pitch, planar ? 0 : (z + 0.5) * pitch});
        s.bodies.velocity.push_back(
            {random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), planar ? 0 : random.uniform(-0.3, 0.3)});
        s.bodies.spin.push_back({0, 0, random.uniform(-0.05, 0.05)});
        s.bodies.orientation.push_back(planar ? scenes::turn_about({0, 0, 1}, random.uniform(0, 6))
                                              : scenes::random_turn(random));
      }
  for (int axis = 0; axis < (planar ? 2 : 3); ++axis) {
    s.walls.push_back({.axis = axis, .high = false, .position = 0});
    s.walls.push_back({.axis = axis, .high = true, .position = width});
  }
  s.gravity = {0, -0.01, 0};
  s.grain_law = scenes::s3_law(0.2, 0.5);
  s.wall_law = scenes::s3_law(0.2, 0.2);
  s.dt = 0.05;
  return s;
}

Archive state_after(ClusterEngine& engine, int steps) {
  engine.run(steps);
  Archive a;
  engine.save(a);
  return a;
}

TEST(ClusterEngine, checkpoints_bit_for_bit) {
  for (const bool planar : {false, true}) {
    const std::vector<ClusterShape> shapes =
        planar ? std::vector{cross_shape(3), sphere_shape()} : std::vector{star_shape(3), rod_shape(3), cross_shape(2)};
    const ClusterSetup s = crowd(shapes, 4, planar, DuplicateRule::literal);
    ClusterEngine straight(s);
    const Archive middle = state_after(straight, 3000), end = state_after(straight, 3000);
    ClusterEngine other(s);
    other.load(middle);
    EXPECT_EQ(state_after(other, 3000), end);
    ClusterSetup wrong = s;
    wrong.walls.pop_back();
    ClusterEngine different(wrong);
    EXPECT_THROW(different.load(middle), Error);
  }
}

TEST(ClusterEngine, every_kernel_gives_the_same_bits) {
  for (const bool planar : {false, true})
    for (const DuplicateRule duplicates : {DuplicateRule::literal, DuplicateRule::merge}) {
      const std::vector<ClusterShape> shapes = planar ? std::vector{cross_shape(1.1), cross_shape(4)}
                                                      : std::vector{star_shape(1.1), rod_shape(3), star_shape(4)};
      ClusterSetup s = crowd(shapes, 4, planar, duplicates);
      s.parallel = planar ? ParallelRule::blend : ParallelRule::middle;
      ClusterEngine plain(s, plain_cluster_kernels());
      const Archive expected = state_after(plain, 4000);
      plain.compute_forces();
      EXPECT_GT(plain.record().contacts.size(), 10u);
      for (const ClusterKernels* kernels : available_cluster_kernels()) {
        ClusterEngine engine(s, *kernels);
        EXPECT_EQ(state_after(engine, 4000), expected) << kernels->name;
      }
    }
}

/// Touching pairs of arms, by looking at all.
std::size_t brute_force_contacts(const Packing& p) {
  std::vector<std::pair<std::size_t, Arm>> arms;
  for (std::size_t k = 0; k < p.grains.size(); ++k)
    for (const Arm& own : p.shapes[static_cast<std::size_t>(p.grains.shape[k])].arms) {
      const double s = p.grains.scale[k];
      const Quaternion& q = p.grains.orientation[k];
      arms.push_back({k,
                      {p.grains.position[k] + rotate(q, s * own.centre), rotate(q, own.direction), s * own.half_length,
                       s * own.radius}});
    }
  std::size_t count = 0;
  for (std::size_t a = 0; a < arms.size(); ++a)
    for (std::size_t b = a + 1; b < arms.size(); ++b)
      count += arms[a].first != arms[b].first &&
               axis_distance(arms[a].second, arms[b].second) < arms[a].second.radius + arms[b].second.radius;
  return count;
}

// Skins are chosen body by body; fast bodies among slow ones, and walls that move, are where a list could be too short.
TEST(ClusterEngine, the_list_misses_no_contact) {
  for (const bool planar : {false, true}) {
    ClusterSetup s =
        crowd(planar ? std::vector{cross_shape(4), sphere_shape()} : std::vector{star_shape(4), rod_shape(3)},
              planar ? 6 : 4, planar, DuplicateRule::literal);
    for (std::size_t k = 0; k < s.bodies.size(); k += 7) s.bodies.velocity[k][0] = 0.5;
    s.walls[3].velocity = -0.005;
    ClusterEngine engine(s);
    std::size_t seen = 0;
    for (int k = 0; k < 100; ++k) {
      engine.run(33);
      engine.compute_forces();
      const Packing p = engine.record();
      std::size_t pairs = 0, ends = 0, touching_ends = 0;
      for (const std::int32_t j : p.contacts.j) ++(j < 0 ? ends : pairs);
      EXPECT_EQ(pairs, brute_force_contacts(p));
      for (std::size_t g = 0; g < p.grains.size(); ++g)
        for (const Arm& own : p.shapes[static_cast<std::size_t>(p.grains.shape[g])].arms)
          for (int end = own.half_length > 0 ? -1 : 1; end <= 1; end += 2) {
            const Vec3 tip = p.grains.position[g] +
                             rotate(p.grains.orientation[g],
                                    p.grains.scale[g] * (own.centre + (end * own.half_length) * own.direction));
            for (const Wall& wall : p.walls)
              touching_ends += dot(tip - wall.position, wall.normal) < p.grains.scale[g] * own.radius;
          }
      EXPECT_EQ(ends, touching_ends);
      seen += pairs;
      engine.advance();
    }
    EXPECT_GT(seen, 300u);
  }
}

/// Drift of the ledger over a time, as a part of the energy turned over.
double ledger_drift(DuplicateRule duplicates, double dt) {
  ClusterSetup s = crowd({star_shape(3)}, 4, false, duplicates);
  s.dt = dt;
  ClusterEngine engine(s);
  const double start = scenes::now(engine).energy.sum();
  engine.run(std::llround(150 / dt));
  engine.compute_forces();
  const EnergyLedger ledger = engine.record().energy;
  return (ledger.sum() - start) / ledger.turned_over();
}

// First order, as dissipation is booked with the velocities that the forces see.
TEST(ClusterEngine, the_ledger_of_a_crowd_closes) {
  for (const DuplicateRule duplicates : {DuplicateRule::literal, DuplicateRule::merge}) {
    const double coarse = ledger_drift(duplicates, 0.02), fine = ledger_drift(duplicates, 0.005);
    EXPECT_LT(std::abs(coarse), 0.05);
    EXPECT_LT(std::abs(fine), std::abs(coarse) / 3);
  }
}

TEST(ClusterEngine, spheres_move_as_in_the_engine_of_spheres) {
  ClusterSetup s = crowd({sphere_shape()}, 4, false, DuplicateRule::literal);
  s.kind = NormalLaw::linear;
  EngineSetup<3> e;
  for (std::size_t k = 0; k < s.bodies.size(); ++k) {
    const double scale = s.bodies.scale[k];
    e.radius.push_back(scale / 2);
    e.mass.push_back(scale * scale * scale);
    e.inertia.push_back(0.4 * e.mass.back() * scale * scale / 4);
  }
  e.position = s.bodies.position;
  e.velocity = s.bodies.velocity;
  e.spin = s.bodies.spin;
  for (const ClusterWall& wall : s.walls)
    e.walls.push_back({WallKind::plane, wall.axis, wall.high, wall.position, 0, 0, {}, {}});
  e.gravity = s.gravity;
  e.grain_law = s.grain_law;
  e.wall_law = s.wall_law;
  e.dt = s.dt;
  ClusterEngine clusters(s);
  Engine<3> spheres(e);
  std::size_t contacts = 0;
  for (int k = 0; k < 12; ++k) {
    clusters.run(50), spheres.run(50);
    clusters.compute_forces(), spheres.compute_forces();
    const Packing a = clusters.record(), b = spheres.record();
    clusters.advance(), spheres.advance();
    ASSERT_EQ(a.contacts.i, b.contacts.i);
    contacts += a.contacts.size();
    for (std::size_t g = 0; g < a.grains.size(); ++g) {
      EXPECT_LT(norm(a.grains.position[g] - b.grains.position[g]), 1e-9);
      EXPECT_LT(norm(a.grains.spin[g] - b.grains.spin[g]), 1e-9);
    }
    for (std::size_t c = 0; c < a.contacts.size(); ++c) {
      EXPECT_NEAR(a.contacts.normal_force[c], b.contacts.normal_force[c], 1e-9);
      EXPECT_LT(norm(a.contacts.tangential_force[c] - b.contacts.tangential_force[c]), 1e-9);
    }
    EXPECT_NEAR(a.energy.sum(), b.energy.sum(), 1e-9);
    for (std::size_t w = 0; w < a.walls.size(); ++w) EXPECT_LT(norm(a.walls[w].force - b.walls[w].force), 1e-9);
  }
  EXPECT_GT(contacts, 50u);
}

// A rod slides over the end of another and off it: the closest point goes from the side to the cap, and the spring
// stays.
TEST(ClusterHistory, survives_the_slide_from_side_to_cap) {
  ClusterSetup s = scenes::two_bodies(rod_shape(4), 0, 0.002);
  s.grain_law = scenes::s3_law(0, 1e6);
  s.grain_law.k_t = 0.01, s.grain_law.inverse_k_t = 100;
  const double end = 1.5;
  s.bodies.position[1] = {end - 0.3, 0, 1.001};
  s.bodies.velocity = {Vec3{}, Vec3{0.4, 0, -0.1}};
  s.bodies.orientation[1] = scenes::turn_about({0, 0, 1}, 1.5707963);
  ClusterEngine engine(s);
  double before = 0, largest_step = 0, strongest = 0;
  bool side = false, cap = false;
  for (int k = 0; k < 3000; ++k) {
    const Packing p = scenes::now(engine);
    if (p.contacts.size() == 0) {
      if (side) break;
      continue;
    }
    ASSERT_EQ(p.contacts.size(), 1u);
    const Vec3 own = rotate(conjugate(p.grains.orientation[0]), p.contacts.point[0] - p.grains.position[0]);
    (own[0] < end - 1e-6 ? side : cap) = true;
    const double force = norm(p.contacts.tangential_force[0]);
    if (k > 0) largest_step = std::max(largest_step, std::abs(force - before));
    before = force;
    strongest = std::max(strongest, force);
  }
  EXPECT_TRUE(side && cap);
  EXPECT_GT(strongest, 0.002);
  EXPECT_LT(largest_step, 1e-4);
}

TEST(ClusterDuplicates, nine_contacts_of_two_short_stars_or_one) {
  ClusterSetup s = scenes::two_bodies(star_shape(1.1), 0, 0.01);
  s.bodies.position[1] = {0.5, 0.5, 0.4};
  s.bodies.spin[0] = {0.1, 0, 0};
  s.grain_law = scenes::s3_law(0.2, 0.5);
  ClusterEngine literal(s);
  literal.compute_forces();
  EXPECT_EQ(literal.record().contacts.size(), 9u);
  s.duplicates = DuplicateRule::merge;
  ClusterEngine merged(s);
  merged.compute_forces();
  const Packing p = merged.record();
  ASSERT_EQ(p.contacts.size(), 1u);
  const Packing all = literal.record();
  EXPECT_EQ(p.contacts.overlap[0], *std::max_element(all.contacts.overlap.begin(), all.contacts.overlap.end()));
  for (std::size_t c = 1; c < all.contacts.size(); ++c)
    EXPECT_LT(std::pair(all.contacts.part_i[c - 1], all.contacts.part_j[c - 1]),
              std::pair(all.contacts.part_i[c], all.contacts.part_j[c]));
}

TEST(ClusterEngine, bodies_may_join_later) {
  const ClusterSetup all = crowd({star_shape(2)}, 3, false, DuplicateRule::literal);
  ClusterSetup some = all;
  ClusterBodies rest;
  const auto split = [](auto& values, auto& into) {
    into.assign(values.begin() + 20, values.end());
    values.resize(20);
  };
  split(some.bodies.shape, rest.shape), split(some.bodies.scale, rest.scale);
  split(some.bodies.position, rest.position), split(some.bodies.velocity, rest.velocity);
  split(some.bodies.spin, rest.spin), split(some.bodies.orientation, rest.orientation);
  ClusterEngine at_once(all), in_turn(some);
  in_turn.add(rest);
  EXPECT_EQ(in_turn.grains(), 27u);
  at_once.run(500), in_turn.run(500);
  at_once.compute_forces(), in_turn.compute_forces();
  const Packing a = at_once.record(), b = in_turn.record();
  EXPECT_EQ(a.grains.id, b.grains.id);
  for (std::size_t k = 0; k < 27; ++k) EXPECT_LT(norm(a.grains.position[k] - b.grains.position[k]), 1e-10);
  // a checkpoint holds the newcomers
  in_turn.advance();
  Archive saved;
  in_turn.save(saved);
  ClusterSetup first = all;
  ClusterEngine fresh(some);
  fresh.load(saved);
  EXPECT_EQ(state_after(fresh, 200), state_after(in_turn, 200));
}

TEST(ClusterEngine, gives_up_where_axes_are_about_to_cross) {
  ClusterSetup s = scenes::two_bodies(rod_shape(4), 2.0, 0.01);
  s.bodies.orientation[1] = scenes::turn_about({0, 0, 1}, 1.5707963);
  s.grain_law.k_n = 0.01;
  ClusterEngine engine(s);
  try {
    engine.run(10000);
    FAIL();
  } catch (const Diverged& d) {
    const std::string what = d.what();
    EXPECT_NE(what.find("body 0"), std::string::npos) << what;
    EXPECT_NE(what.find("body 1"), std::string::npos) << what;
  }
  s.bodies.position[1] = {0, 0, 0};  // axes cross from the start
  EXPECT_THROW(ClusterEngine{s}, Diverged);
  s.bodies.position[1] = {9, 0, 0};
  s.bodies.velocity[0][0] = std::nan("");
  EXPECT_THROW(ClusterEngine{s}, Diverged);
}

TEST(ClusterEngine, refuses_what_is_no_body) {
  ClusterSetup s = scenes::two_bodies(rod_shape(4), 0, 0.01);
  s.bodies.shape[1] = 1;
  EXPECT_THROW(ClusterEngine{s}, Error);
  s = scenes::two_bodies(star_shape(3), 0, 0.01);
  s.planar = true;
  EXPECT_THROW(ClusterEngine{s}, Error);
  s = scenes::two_bodies(rod_shape(3), 0, 0.01);
  s.bodies.scale = {1, 0};
  EXPECT_THROW(ClusterEngine{s}, Error);
}

}  // namespace
}  // namespace jam
