// Collisions of rods, crosses and stars beside LAMMPS, which knows them as rigid clumps of overlapping spheres: the
// velocities and spins after a collision, as root mean square over pairs in random attitudes that turn and slide.
//
// What may differ:
//   ends    Two ends touch as one pair of spheres, which a clump has too. Without friction nothing differs but
//   round-off.
//           With friction LAMMPS's lever arm is the radius, ours ends in the middle of the overlap: a relative error of
//           the overlap x / d, so half of it at four times the stiffness.
//   sides   Spheres at a spacing e make a cylinder with dips e^2 / (8 r) deep, whose normals lean by up to e / (4 r) =
//   e / 2d.
//           The leaning normal meets the slip (up to 2.5 here) and sends it back, twice: an error of up to 2.5 e / d.
//           When the dips are shallower than the overlap, many pairs carry the contact and their normals average out:
//           the error falls faster, down to that of the overlap. Many springs are one spring of another law, so only
//           outcomes that do not depend on the law can be compared: no damping, and friction that slides all the time.
//           Stiffness is split among the pairs, so that the overlap stays the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "impacts.hpp"
#include "jamscape/geometry/cluster_shape.hpp"
#include "lammps_clumps.hpp"
#include "lammps_program.hpp"

namespace jam::clusters {
namespace {

const ClusterShape shapes[] = {rod_shape(4), cross_shape(4), star_shape(6)};
constexpr double slip_most = 2.5;  // impacts.hpp

/// A law and the step for it: overlaps of up to about `overlap` when two bodies meet at a normal speed of 1/2.
struct Trial {
  Law law;
  double dt;
  static constexpr int steps = 800;  // a collision lasts up to 200

  Trial(const ClusterShape& shape, double overlap, double mu) {
    const double reduced_mass = shape.volume / 2;
    law.k_n = reduced_mass * 0.25 / (overlap * overlap);
    law.k_t = 2 * law.k_n;
    law.mu = mu;
    dt = std::numbers::pi * std::sqrt(reduced_mass / law.k_n) / 200;
  }
};

/// Law of one pair of spheres where a contact of this overlap has several: their number at spacing e is what makes the
/// energy k x^2 / 2 at the largest overlap the same.
Law split(const Law& law, Place place, double spacing, double overlap) {
  const double r = 0.5;
  const double pairs = place == Place::sides ? 4 * std::numbers::pi / 3 * r * overlap / (spacing * spacing)
                                             : std::sqrt(4 * r * overlap) / spacing;
  Law one = law;
  one.k_n = law.k_n / std::max(1.0, pairs);
  one.k_t = law.k_t / std::max(1.0, pairs);
  return one;
}

/// A folder of its own for each test: they may run at the same time.
std::string folder() { return testing::UnitTest::GetInstance()->current_test_info()->name(); }

double half(const ClusterShape& shape) { return shape.length / 2; }

/// How much the collision changes: what errors are to be held against.
double change(const Impacts& impacts, const Motion& after) {
  return difference(after, {impacts.bodies.velocity, impacts.bodies.spin}, half(impacts.shape));
}

double ends_error(const ClusterShape& shape, double overlap, const Trial& trial) {
  const Impacts impacts = draw(shape, Place::ends, 6, overlap / 4, 5);
  const Motion ours = collide(impacts, trial.law, trial.dt, trial.steps);
  EXPECT_GT(change(impacts, ours), 0.2);
  return difference(ours, collide_clumps(folder(), impacts, trial.law, 17, trial.dt, trial.steps), half(shape));
}

TEST(ClumpsOfLammps, ends_without_friction_are_the_same) {
  if (!lammps::installed()) GTEST_SKIP() << "LAMMPS (the program lmp) is not installed; ./setup peers installs it";
  for (const ClusterShape& shape : shapes) {
    SCOPED_TRACE(shape.name);
    Trial trial(shape, 0.002, 0);
    trial.law.gamma_n = 0.4 * std::sqrt(2 * trial.law.k_n / shape.volume);  // restitution of two free spheres: .53
    // The dashpot sees velocities, and rods and crosses turn freely by another scheme of second order in LAMMPS.
    EXPECT_LT(ends_error(shape, 0.002, trial), shape.name == "star" ? 1e-9 : 1e-6);
    trial.law.gamma_n = 0;
    EXPECT_LT(ends_error(shape, 0.002, trial), 1e-9);
  }
}

TEST(ClumpsOfLammps, ends_with_friction_differ_by_the_overlap) {
  if (!lammps::installed()) GTEST_SKIP() << "LAMMPS (the program lmp) is not installed; ./setup peers installs it";
  for (const ClusterShape& shape : shapes)
    for (const double mu : {0.2, 0.5, 1.5}) {  // the last: mostly sticking
      SCOPED_TRACE(testing::Message() << shape.name << ", mu = " << mu);
      double before = 0;
      for (const double overlap : {0.004, 0.002, 0.001}) {
        Trial trial(shape, overlap, mu);
        trial.law.gamma_n = 0.4 * std::sqrt(2 * trial.law.k_n / shape.volume);
        trial.law.gamma_t = trial.law.gamma_n / 2;
        const double error = ends_error(shape, overlap, trial);
        EXPECT_LT(error, slip_most * overlap);
        // A contact that sticks to its end may slip in its last steps in one program only: no even fall there.
        if (before > 0 && mu < 1) {
          EXPECT_NEAR(before / error, 2, 0.3);
        }
        before = error;
      }
    }
}

void compare_sides(Place place, double mu) {
  constexpr double overlap = 0.002;
  for (const ClusterShape& shape : shapes) {
    SCOPED_TRACE(testing::Message() << shape.name << ", mu = " << mu);
    const Trial trial(shape, overlap, mu);
    const Impacts impacts = draw(shape, place, 6, overlap / 4, 5);
    const Motion ours = collide(impacts, trial.law, trial.dt, trial.steps);
    EXPECT_GT(change(impacts, ours), 0.2);
    double first = 0, before = 0;
    for (const int spheres : {33, 65, 129}) {
      SCOPED_TRACE(testing::Message() << spheres << " spheres an arm");
      const double spacing = 2 * shape.arms[0].half_length / (spheres - 1);
      const Motion theirs =
          collide_clumps(folder(), impacts, split(trial.law, place, spacing, overlap), spheres, trial.dt, trial.steps);
      const double error = difference(ours, theirs, half(shape));
      EXPECT_LT(error, slip_most * (spacing + overlap));
      if (before > 0) {
        EXPECT_LT(error, before / 2);
      }
      if (before == 0) first = error;
      before = error;
    }
    EXPECT_LT(before, first / 10) << "faster than the spacing";
    EXPECT_LT(before, slip_most * overlap) << "many spheres: what the overlap allows";
  }
}

TEST(ClumpsOfLammps, sides_come_nearer_with_more_spheres) {
  if (!lammps::installed()) GTEST_SKIP() << "LAMMPS (the program lmp) is not installed; ./setup peers installs it";
  for (const double mu : {0.0, 0.2}) compare_sides(Place::sides, mu);
}

TEST(ClumpsOfLammps, an_end_on_a_side_comes_nearer_with_more_spheres) {
  if (!lammps::installed()) GTEST_SKIP() << "LAMMPS (the program lmp) is not installed; ./setup peers installs it";
  for (const double mu : {0.0, 0.2}) compare_sides(Place::side, mu);
}

}  // namespace
}  // namespace jam::clusters
