// The bodies of a simulation of clusters, in memory: numbers by who touches them. Bodies are kept in spatial order, the
// arms of a body one after another; `id` says who is who. Two far-away arms fill up the last block of arm
// pairs; they are counted nowhere.
//
//   body row, 128 bytes   x y z mass | vx vy vz 0 | wx wy wz reach | qw qx qy qz
//   arm row, 64 bytes     cx cy cz r | ux uy uz h          in the world's frame, made anew in every step
//   force row, 64 bytes   fx fy fz 0 | tx ty tz 0          torque about the centre of mass
//
// Velocities, spins and angular momenta are those of half a step ago. `reach`: no point of an axis is farther from the
// centre of mass.
#pragma once

#include <cstdint>
#include <vector>

#include "jamscape/dem/rows.hpp"
#include "jamscape/geometry/cluster.hpp"
#include "jamscape/geometry/quaternion.hpp"
#include "jamscape/geometry/segments.hpp"

namespace jam {

/// Bodies as a protocol names them; all arrays have the same length, or are empty: scale 1, velocity and spin 0,
/// orientation that of the shape's frame.
struct ClusterBodies {
  std::vector<std::int32_t> shape;  ///< index of a shape
  std::vector<double> scale;        ///< size factor of the whole body
  std::vector<Vec3> position;       ///< of the centre of mass
  std::vector<Vec3> velocity, spin;
  std::vector<Quaternion> orientation;  ///< from the shape's frame to the world's

  std::size_t size() const { return shape.size(); }
};

struct ClusterRow {
  static constexpr std::size_t stride = 16, force_stride = 8, arm_stride = 8;
  static constexpr std::size_t position = 0, mass = 3, velocity = 4, spin = 8, reach = 11, orientation = 12;
};

struct ClusterState {
  // hot: every contact reads rows and arms, every step writes them
  Aligned<double> rows, arms;
  Aligned<double> forces;  ///< cleared by the integrator
  // warm: read by the integrator once a step
  Aligned<double> momentum;  ///< angular momentum in the world's frame and 0, a body
  Aligned<double> inverse;   ///< like force rows: inverse masses, then inverse moments of inertia along the body's axes
  /// No point of a body has gone farther than `moved` since the list of arm pairs was made; the list must be made anew
  /// before that exceeds `skin`, for any body.
  Aligned<double> moved, skin;
  Aligned<std::uint8_t> top;             ///< 1: moments of inertia differ, the body turns as a free top
  std::vector<std::uint32_t> first_arm;  ///< of each body, and the end
  std::vector<double> scale;             ///< of a body, over its shape
  Aligned<double> own_arms;              ///< like arm rows, in the shapes' frames, one shape after another
  std::vector<std::uint32_t> first_own;  ///< where in `own_arms` those of a body begin
  bool centred = false;                  ///< the centres of all arms are those of their bodies
  // cold
  std::vector<std::uint32_t> id;        ///< of bodies
  std::vector<std::uint32_t> arm_id;    ///< number of the arm, counted in the order of ids
  std::vector<std::uint32_t> arm_body;  ///< the body of an arm
  std::vector<std::int32_t> shape;
  std::vector<double> radius;  ///< of the circumscribed sphere

  std::size_t count() const { return id.size(); }
  std::size_t arm_count() const { return arm_id.size(); }
  double* row(std::size_t k) { return rows.data() + k * ClusterRow::stride; }
  const double* row(std::size_t k) const { return rows.data() + k * ClusterRow::stride; }
  const double* arm(std::size_t a) const { return arms.data() + a * ClusterRow::arm_stride; }
  double* force(std::size_t k) { return forces.data() + k * ClusterRow::force_stride; }
  const double* force(std::size_t k) const { return forces.data() + k * ClusterRow::force_stride; }
  Quaternion orientation(std::size_t k) const {
    const double* q = row(k) + ClusterRow::orientation;
    return {q[0], q[1], q[2], q[3]};
  }
};

inline Vec3 vec3(const double* p) { return {p[0], p[1], p[2]}; }
inline Segment<double> axis_of(const double* arm) { return {vec3(arm), vec3(arm + 4), arm[7]}; }

/// Appends bodies; velocities are taken as they are. Mass = density volume scale^3. In the plane z, tilt, and the
/// velocities that would change them are 0. Throws a usage error for what is no such body.
void append_bodies(ClusterState& state, const ClusterBodies& bodies, const std::vector<ClusterShape>& shapes,
                   double density, bool planar);

/// Appends the arms of shape * scale and counts all; used where a state is built from stored numbers.
void rebuild_arms(ClusterState& state, const std::vector<ClusterShape>& shapes);

/// The bodies in spatial order (Morton order of cells of about a body): order[k] = present index of the k-th.
std::vector<std::uint32_t> spatial_order(const ClusterState& state);
/// Puts them into that order.
void reorder(ClusterState& state, const std::vector<std::uint32_t>& order, const std::vector<ClusterShape>& shapes);

/// Spin of a body whose angular momentum in the world's frame is l.
Vec3 spin_of(const ClusterState& state, std::size_t body, const Vec3& l);
/// Sets the spins in the rows, and the arms, by orientation and angular momentum.
void refresh(ClusterState& state);

}  // namespace jam
