// The packing: grains, contacts, box and walls at one instant. The waist of the hourglass: everything that makes
// grains ends in it, everything that measures starts from it. Its contact arrays are the force network.
//
// Conventions (every reader converts to these):
//   - vectors have three components; in two dimensions z = 0 and only the z component of spins and torques is used;
//   - a contact is stored once, between grains i < j, or between grain i and wall j = -1 - w;
//   - the unit normal n points from i to j; normal_force > 0 is repulsive; the force on i is
//         f_i = -normal_force n + tangential_force,      the force on j is -f_i;
//   - overlap > 0 while the grains touch; tangential_force is perpendicular to n;
//   - point lies in the middle of the overlap, on the line of centres (clusters: of the closest points of two axes);
//   - a body made of several arms touches with each of them: part_i and part_j are the arms, and a wall sees the ends
//     of an arm, part_j = 0 or 1;
//   - in a periodic box the copy of j that touches i sits at x_j + sum over k of image_k * edge_k.
// Units are those of the study (scaled units d, m, tau_c in S1).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "jamscape/geometry/cluster.hpp"
#include "jamscape/geometry/quaternion.hpp"
#include "jamscape/geometry/vec.hpp"

namespace jam {

/// Grains in the order of their ids; all arrays have the same length, but that those of clusters are empty in a packing
/// of discs or spheres.
struct Grains {
  std::vector<std::int64_t> id;       ///< stable name of a grain
  std::vector<std::int32_t> species;  ///< material and size class
  std::vector<double> radius;         ///< clusters: of the circumscribed sphere
  std::vector<double> mass;
  std::vector<Vec3> position;
  std::vector<Vec3> velocity;
  std::vector<Vec3> spin;   ///< angular velocity
  std::vector<Vec3> angle;  ///< accumulated rotation (2D: z); zero where it is not tracked

  std::vector<std::int32_t> shape;      ///< clusters: index into Packing::shapes
  std::vector<double> scale;            ///< clusters: size factor of the whole body
  std::vector<Quaternion> orientation;  ///< clusters: from the shape's frame to the packing's

  std::size_t size() const { return id.size(); }
};

/// Contacts, sorted by (i, j, part_i, part_j); all arrays have the same length.
struct Contacts {
  std::vector<std::uint32_t> i;       ///< index of a grain
  std::vector<std::int32_t> j;        ///< index of a grain, or -1 - w for wall w
  std::vector<std::uint16_t> part_i;  ///< part of body i (0 for discs and spheres)
  std::vector<std::uint16_t> part_j;  ///< part of body j; for a wall of beads, the bead
  std::vector<std::array<std::int8_t, 3>> image;
  std::vector<double> overlap;
  std::vector<double> normal_force;  ///< signed: may be slightly negative under an unclipped dashpot
  std::vector<Vec3> normal;
  std::vector<Vec3> tangential_force;  ///< on i
  std::vector<Vec3> point;
  std::vector<std::uint8_t> sliding;  ///< 1 where the Coulomb limit is reached

  std::size_t size() const { return i.size(); }
};

enum class WallKind : std::uint8_t { plane, beads, cylinder };

/// What a wall is for: below the grains, on top of them (what presses on a settled packing), or anything else.
enum class WallRole : std::uint8_t { side, floor, lid };

/// A wall: a plane, a straight row (2D) of touching beads that moves as one rigid piece along its normal, or an upright
/// cylinder around the grains.
struct Wall {
  WallKind kind = WallKind::plane;
  Vec3 position{};  ///< a point of the plane, of the line through the bead centres, or of the cylinder's axis
  Vec3 normal{};    ///< unit vector, pointing into the domain; cylinder: along its axis
  Vec3 velocity{};
  Vec3 force{};             ///< total force of the grains on the wall
  double bead_radius = 0;   ///< beads only
  std::vector<Vec3> beads;  ///< centres of the beads; part_j of a contact is the index here
  double radius = 0;        ///< cylinder only
  WallRole role = WallRole::side;
};

/// The cell the grains are in: a corner and three edge vectors, each of which may be periodic. Edge k is
/// (hi - lo)_k along axis k and tilt[k] besides, so that in an upright cell lo and hi are the corners, kept to the bit.
struct Domain {
  Vec3 lo{}, hi{};                 ///< for bead walls: the lines (planes) through the bead centres
  std::array<bool, 3> periodic{};  ///< whether the grains repeat along an edge
  std::array<Vec3, 3> tilt{};      ///< of edge k, without component k; zero in an upright cell

  bool upright() const { return tilt == std::array<Vec3, 3>{}; }
  Vec3 edge(int k) const {
    Vec3 e = tilt[static_cast<std::size_t>(k)];
    e[k] = hi[k] - lo[k];
    return e;
  }
};

/// Where the energy went since the start; closes to the integrator's order:
///   kinetic + elastic + damped + rubbed - wall_work - gravity_work = constant
struct EnergyLedger {
  double kinetic = 0;       ///< translation and rotation, now
  double elastic = 0;       ///< normal and tangential springs, now
  double damped = 0;        ///< taken by the dashpots since the start
  double rubbed = 0;        ///< taken by friction (springs cut at the Coulomb limit or erased) since the start; with a
                            ///< Hertz law all that tangential forces took, negative where the law makes energy
  double wall_work = 0;     ///< done on the grains by moving walls or a deforming box since the start
  double gravity_work = 0;  ///< done on the grains by gravity since the start

  /// Constant along a run, to the integrator's order.
  double sum() const { return kinetic + elastic + damped + rubbed - wall_work - gravity_work; }
  /// What has changed hands so far, against which the error is to be seen.
  double turned_over() const {
    return std::abs(damped) + std::abs(rubbed) + std::abs(wall_work) + std::abs(gravity_work);
  }
};

/// What a packing knows of itself; the rest holds zeros that mean nothing. Ours know everything.
struct Knowledge {
  bool masses = true;  ///< not assumed
  bool velocities = true;
  bool spins = true;
  bool angles = true;  ///< accumulated rotations
  bool tangential_forces = true;
  bool sliding = true;   ///< which contacts have reached the Coulomb limit
  bool energies = true;  ///< the ledger
  bool operator==(const Knowledge&) const = default;
};

struct Packing {
  int dimension = 2;
  std::int64_t step = 0;
  double time = 0;
  std::string stage;                  ///< name of the protocol stage this instant belongs to
  std::string relaxation;             ///< what ended the relaxation before this instant; empty where there was none
  double packing_fraction = 0;        ///< in the study's box and grain-area convention
  double packing_fraction_plain = 0;  ///< true grain area (volume), over the same box
  Domain domain;                      ///< of a cylinder: the box around it
  std::vector<ClusterShape> shapes;   ///< empty: discs or spheres
  Grains grains;
  Contacts contacts;
  std::vector<Wall> walls;
  EnergyLedger energy;
  Knowledge knows;
};

}  // namespace jam
