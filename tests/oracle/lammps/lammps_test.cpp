// Our engine beside LAMMPS: a packing of some 600 equal spheres between flat walls, nearly jammed and sheared, Hertz
// law with tangential history, from the same positions, velocities and spins.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "lammps_program.hpp"
#include "lammps_run.hpp"

namespace jam::lammps {
namespace {

constexpr double dt = 6e-4;  // a collision of two spheres at unit speed lasts about 100 of these steps

double largest(const Vec3& a) { return std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])}); }

/// The packing after `steps` steps of ours, the first of which LAMMPS has done.
Packing after(const State<3>& start, int steps) {
  Engine<3> engine = enter(start);
  engine.run(steps - 1);
  engine.compute_forces();
  return engine.record();
}

struct Differences {
  double position = 0, velocity = 0, spin = 0;
};

/// Root mean squares over the grains.
Differences compare(const Packing& ours, const Followed& theirs) {
  Differences sum;
  const auto n = static_cast<double>(theirs.position.size());
  for (std::size_t k = 0; k < theirs.position.size(); ++k) {
    Vec3 d = ours.grains.position[k] - theirs.position[k];
    for (int c = 0; c < 3; ++c)
      if (const double period = theirs.start.box.length[static_cast<std::size_t>(c)]; period > 0)
        d[c] -= period * std::round(d[c] / period);
    const Vec3 v = ours.grains.velocity[k] - theirs.velocity[k], w = ours.grains.spin[k] - theirs.spin[k];
    sum.position += dot(d, d) / n, sum.velocity += dot(v, v) / n, sum.spin += dot(w, w) / n;
  }
  return {std::sqrt(sum.position), std::sqrt(sum.velocity), std::sqrt(sum.spin)};
}

TEST(Lammps, spheres_follow_contact_by_contact) {
  if (!installed()) GTEST_SKIP() << "LAMMPS (the program lmp) is not installed; ./setup peers installs it";
  const Packed packed("follow");
  for (const int steps : {1, 10, 100, 300, 1000}) {
    SCOPED_TRACE(testing::Message() << "step " << steps);
    const Followed theirs = packed.follow(dt, steps);
    const Packing ours = after(theirs.start, steps);

    const Contacts& c = ours.contacts;
    ASSERT_EQ(c.size(), theirs.contacts.size());
    double mean = 0, normal = 0, tangential = 0;
    for (const double f : c.normal_force) mean += std::abs(f) / static_cast<double>(c.size());
    std::size_t sliding = 0, sticking = 0, at_walls = 0;
    for (std::size_t k = 0; k < c.size(); ++k) {
      const auto at = theirs.contacts.find({static_cast<int>(c.i[k]), c.j[k]});
      ASSERT_NE(at, theirs.contacts.end()) << "contact of " << c.i[k] << " and " << c.j[k];
      normal = std::max(normal, std::abs(c.normal_force[k] - at->second.normal) / mean);
      tangential = std::max(tangential, largest(c.tangential_force[k] - at->second.tangential) / mean);
      ++(c.sliding[k] ? sliding : sticking);
      at_walls += c.j[k] < 0;
    }
    EXPECT_LT(normal, 1e-9);
    EXPECT_LT(tangential, 1e-9);
    for (const std::size_t contacts : {sliding, sticking}) EXPECT_GT(contacts, 200u);
    EXPECT_GT(at_walls, 50u);
    const Differences grains = compare(ours, theirs);
    EXPECT_LT(grains.position, 1e-10);
    EXPECT_LT(grains.velocity, 1e-10);
    EXPECT_LT(grains.spin, 1e-10);
  }
}

/// Our engine's own start sees LAMMPS's v(0) as v(-1/2) + a dt/2 and advances springs in its first step, which LAMMPS's
/// set-up does not: two discretisations that differ by a step's worth of springs, so by half as much at half the dt.
TEST(Lammps, a_start_of_our_own_differs_by_the_first_order_of_dt) {
  if (!installed()) GTEST_SKIP() << "LAMMPS (the program lmp) is not installed; ./setup peers installs it";
  const Packed packed("first_order");
  Differences before;
  for (const int refined : {1, 2, 4}) {
    const int steps = 100 * refined;
    const Followed theirs = packed.follow(dt / refined, steps);
    Engine<3> engine(setup_of(theirs.start));
    engine.run(steps);
    engine.compute_forces();
    const Differences now = compare(engine.record(), theirs);
    if (refined > 1) {
      EXPECT_NEAR(before.position / now.position, 2, 0.1);
      EXPECT_NEAR(before.velocity / now.velocity, 2, 0.1);
      EXPECT_NEAR(before.spin / now.spin, 2, 0.1);
    }
    before = now;
  }
}

}  // namespace
}  // namespace jam::lammps
