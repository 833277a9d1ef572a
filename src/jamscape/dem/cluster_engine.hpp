// Rigid clusters of spherocylinders in motion (theory sec. 3): the sibling of Engine for bodies made of arms, with the
// same clock: run(n) makes n steps; forces asked for at an instant are kept until the clock goes on, and booked once.
//
// Two arms of different bodies have at most one contact, at their closest points; a wall touches the two ends of an
// arm, each with a contact of its own. Springs are kept by (body, arm, body, arm) and by (wall, body, arm, end), from
// first touch to separation. Forces and torques sum at the centre of mass: torque on i = (point - x_i) x force.
//
// Integration: leapfrog of positions and velocities, and of orientations and angular momenta in the world's frame, so
// that momentum and angular momentum are kept to round-off. Bodies of one moment of inertia (spheres, stars) and all
// bodies in the plane turn by their spin; others by the symmetric splitting into turns about their own axes
// [dullweber1997], of second order, whose energy does not drift.
//
// Lengths in d (diameter of an arm), masses in m, times in tau_c; any consistent units will do.
#pragma once

#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "jamscape/base/archive.hpp"
#include "jamscape/contact/law.hpp"
#include "jamscape/dem/cluster_bodies.hpp"
#include "jamscape/dem/cluster_kernel.hpp"
#include "jamscape/dem/cluster_list.hpp"
#include "jamscape/dem/cluster_rules.hpp"
#include "jamscape/dem/cluster_walls.hpp"
#include "jamscape/dem/contact_record.hpp"
#include "jamscape/dem/diverged.hpp"
#include "jamscape/packing/packing.hpp"

namespace jam {

struct ClusterSetup {
  std::vector<ClusterShape> shapes;
  ClusterBodies bodies;
  double density = 1;   ///< mass = density * volume * scale^3
  bool planar = false;  ///< two dimensions: z and tilt are frozen
  std::vector<ClusterWall> walls;
  Vec3 gravity{};  ///< acceleration of the bodies
  NormalLaw kind = NormalLaw::ratio;
  PairLaw<> grain_law{}, wall_law{};  ///< lever_cut is not used: the lever is that of the contact point
  double dt = 0.02;
  ParallelRule parallel = ParallelRule::middle;
  double parallel_angle = std::numbers::pi / 90;  ///< in rad
  DuplicateRule duplicates = DuplicateRule::literal;
};

class ClusterEngine {
 public:
  /// Throws a usage error for bodies that name no shape or do not fit the dimension, Diverged for axes that cross.
  explicit ClusterEngine(const ClusterSetup& setup, const ClusterKernels& kernels = best_cluster_kernels());

  /// Forces at the present positions and half-step velocities, unless they are known. Throws Diverged.
  void compute_forces();
  /// One time step.
  void advance() { run(1); }
  /// `n` time steps. Throws Diverged.
  void run(std::int64_t n);

  /// This instant in full. Checks the contacts against the forces; throws Diverged.
  Packing record();

  /// Translation and rotation, with the velocities the forces see (half a step behind).
  double kinetic_energy() const;
  /// Of all contacts at the present positions.
  ElasticEnergy elastic_energy() const;

  std::int64_t step() const { return step_; }
  double time() const { return static_cast<double>(step_) * dt_; }
  std::size_t grains() const { return bodies_.count(); }
  const std::vector<ClusterWall>& walls() const { return walls_; }
  /// Of a plane, along its axis.
  void set_wall_velocity(std::size_t wall, double velocity) { walls_[wall].velocity = velocity; }
  /// Puts a plane elsewhere along its axis, where it touches nobody or does so from the next instant on, if the forces
  /// of this one are known.
  void place_wall(std::size_t wall, double position) {
    walls_[wall].position = position;
    stale_ = true;
  }
  /// Where the bodies end along an axis: the largest coordinate of their surfaces. 0 without bodies.
  double highest(int axis) const;
  /// Of the grains on the wall, at this instant.
  Vec3 wall_force(std::size_t wall) {
    compute_forces();
    return wall_force_[wall];
  }
  /// More bodies from now on; their ids follow on. The constant of the energy ledger rises by their kinetic energy.
  void add(const ClusterBodies& bodies);
  /// Finds numbers that are none; throws Diverged.
  void check() const;

  /// Everything that determines what follows, bit for bit.
  void save(Archive& archive) const;
  /// Into an engine of the same setup, bodies added later included; throws a data error if the archive is of another.
  void load(const Archive& archive);

 private:
  void place(const ClusterBodies& bodies);
  void start_in_step(std::uint32_t first_new);
  void sum_without_clock();
  void forget_forces();
  void sum_forces();
  void make_step();
  double weight_power() const;
  void relist();
  void choose_skins();
  void forget_parted();
  void touch_walls();
  template <NormalLaw law, bool friction>
  void touch_walls();
  /// At this instant, its weight included.
  Vec3 force_on(std::size_t k) const { return vec3(bodies_.force(k)) + bodies_.row(k)[ClusterRow::mass] * gravity_; }
  [[noreturn]] void fail(std::size_t body, const std::string& problem) const;
  [[noreturn]] void fail_deep() const;

  const ClusterKernels* kernels_;
  NormalLaw kind_;
  PairLaw<> grain_law_, wall_law_;
  double dt_, density_;
  bool planar_;
  ParallelRule parallel_;
  double parallel_sine2_;
  DuplicateRule duplicates_;
  std::vector<ClusterShape> shapes_;
  Vec3 gravity_{};

  ClusterState bodies_;
  std::vector<ClusterWall> walls_;
  std::vector<Vec3> wall_force_;
  ArmPairs pairs_;
  ArmContacts contacts_;  ///< of the last forces
  WallEnds ends_;

  std::int64_t step_ = 0;
  double wall_skin_ = 0, walls_moved_ = 0;  ///< as skin and moved of the bodies, for the walls
  bool stale_ = true;
  bool summed_ = false;     ///< the forces of this instant are known, and booked
  std::int64_t lists_ = 0;  ///< made so far; bodies are reordered at some of them
  Booked booked_;
};

}  // namespace jam
