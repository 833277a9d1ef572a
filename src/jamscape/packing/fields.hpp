// Every field of a packing, once: its name, its unit, what it holds, when it is there, and how files call it. Whoever
// writes, reads, compares, documents or lends a packing goes through these lists; a member that is not in them is lost.
//
//   for_each_field(grain_fields, [&](const auto& f) { use(f.name, packing.grains.*f.member); });
//
// A new field is a member of the record and a line here.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "jamscape/packing/packing.hpp"

namespace jam {

/// What one value is. In two dimensions a vector has the components in the plane, a rotation the one out of it; a
/// position in space has three.
enum class FieldShape { scalar, vector, rotation, quaternion, image, place };

/// Which packings have it.
enum class Presence { always, clusters, beads, cylinder };

/// How often a file of several frames holds it.
enum class Kept {
  each_frame,
  once  ///< as long as it does not change
};

struct FieldText {
  const char* name;  ///< of the member
  const char* unit;  ///< in d, m and tau_c; "" where it has none
  const char* meaning;
  FieldShape shape = FieldShape::scalar;
  Presence presence = Presence::always;
  Kept kept = Kept::each_frame;
  const char* stored = nullptr;      ///< name in a run file; null: the member's
  const char* columns = nullptr;     ///< in CSV: names of the components, alternatives after |; null: by the name
  bool Knowledge::*known = nullptr;  ///< what a packing must know for it to mean anything
  bool later = false;                ///< run files written before it was there do without
};

template <class Record, class T>
struct Field : FieldText {
  using Value = T;
  T Record::*member;

  constexpr const char* in_file() const { return stored != nullptr ? stored : name; }
};

template <class Record, class T>
constexpr Field<Record, T> field(T Record::*member, FieldText text) {
  return {text, member};
}

template <class... F, class Visit>
constexpr void for_each_field(const std::tuple<F...>& fields, Visit&& visit) {
  std::apply([&](const auto&... f) { (visit(f), ...); }, fields);
}

inline constexpr auto frame_fields = std::tuple(
    field(&Packing::step, {.name = "step", .unit = "", .meaning = "steps of the integrator since the start"}),
    field(&Packing::time, {.name = "time", .unit = "tau_c", .meaning = "since the start"}),
    field(&Packing::stage, {.name = "stage", .unit = "", .meaning = "name of the protocol's stage"}),
    field(&Packing::relaxation, {.name = "relaxation",
                                 .unit = "",
                                 .meaning = "what ended the relaxation before this frame; empty where there was none",
                                 .later = true}),
    field(&Packing::packing_fraction, {.name = "packing_fraction",
                                       .unit = "",
                                       .meaning = "by the study's conventions of box and grain area",
                                       .stored = "observables/packing_fraction"}),
    field(&Packing::packing_fraction_plain, {.name = "packing_fraction_plain",
                                             .unit = "",
                                             .meaning = "true area (volume) of the grains over the same box",
                                             .stored = "observables/packing_fraction_plain"}));

inline constexpr auto energy_fields = std::tuple(
    field(&EnergyLedger::kinetic, {.name = "kinetic",
                                   .unit = "m d^2/tau_c^2",
                                   .meaning = "of translation and rotation, now",
                                   .stored = "energy_kinetic",
                                   .known = &Knowledge::energies}),
    field(&EnergyLedger::elastic, {.name = "elastic",
                                   .unit = "m d^2/tau_c^2",
                                   .meaning = "of normal and tangential springs, now",
                                   .stored = "energy_elastic",
                                   .known = &Knowledge::energies}),
    field(&EnergyLedger::damped, {.name = "damped",
                                  .unit = "m d^2/tau_c^2",
                                  .meaning = "taken by the dashpots since the start",
                                  .stored = "energy_damped",
                                  .known = &Knowledge::energies}),
    field(&EnergyLedger::rubbed, {.name = "rubbed",
                                  .unit = "m d^2/tau_c^2",
                                  .meaning = "taken by friction since the start",
                                  .stored = "energy_rubbed",
                                  .known = &Knowledge::energies}),
    field(&EnergyLedger::wall_work, {.name = "wall_work",
                                     .unit = "m d^2/tau_c^2",
                                     .meaning = "done on the grains by walls or a deforming box since the start",
                                     .stored = "energy_wall_work",
                                     .known = &Knowledge::energies}),
    field(&EnergyLedger::gravity_work, {.name = "gravity_work",
                                        .unit = "m d^2/tau_c^2",
                                        .meaning = "done on the grains by gravity since the start",
                                        .stored = "energy_gravity_work",
                                        .known = &Knowledge::energies}));

inline constexpr auto domain_fields = std::tuple(
    field(&Domain::lo, {.name = "lo",
                        .unit = "d",
                        .meaning = "corner the edges start from; of bead walls on the lines of bead centres",
                        .shape = FieldShape::place,
                        .stored = "lower"}),
    field(&Domain::hi, {.name = "hi",
                        .unit = "d",
                        .meaning = "component k: end of edge k along axis k; the opposite corner of an upright cell",
                        .shape = FieldShape::place,
                        .stored = "upper"}),
    field(&Domain::periodic, {.name = "periodic",
                              .unit = "",
                              .meaning = "1 where the grains repeat along the edge",
                              .shape = FieldShape::place}),
    field(&Domain::tilt, {.name = "tilt",
                          .unit = "d",
                          .meaning = "row k: what edge k has beside upper - lower along axis k",
                          .shape = FieldShape::place,
                          .later = true}));

inline constexpr auto knowledge_fields =
    std::tuple(field(&Knowledge::masses, {.name = "masses", .unit = "", .meaning = "masses are given, not assumed"}),
               field(&Knowledge::velocities, {.name = "velocities", .unit = "", .meaning = "velocities are given"}),
               field(&Knowledge::spins, {.name = "spins", .unit = "", .meaning = "angular velocities are given"}),
               field(&Knowledge::angles, {.name = "angles", .unit = "", .meaning = "accumulated rotations are given"}),
               field(&Knowledge::tangential_forces,
                     {.name = "tangential_forces", .unit = "", .meaning = "tangential forces are given"}),
               field(&Knowledge::sliding, {.name = "sliding", .unit = "", .meaning = "which contacts slide is given"}),
               field(&Knowledge::energies, {.name = "energies", .unit = "", .meaning = "the energy ledger is given"}));

// In the order of the columns of CSV tables.

inline constexpr auto grain_fields = std::tuple(
    field(&Grains::id, {.name = "id",
                        .unit = "",
                        .meaning = "stable name of the grain",
                        .kept = Kept::once,
                        .columns = "id|particle|particle_id|grain"}),
    field(&Grains::species, {.name = "species",
                             .unit = "",
                             .meaning = "material and size class",
                             .kept = Kept::once,
                             .columns = "species|type|material"}),
    field(&Grains::position, {.name = "position",
                              .unit = "d",
                              .meaning = "of the centre of mass",
                              .shape = FieldShape::vector,
                              .columns = "x y z|pos_x pos_y pos_z|position_x position_y position_z"}),
    field(&Grains::radius, {.name = "radius",
                            .unit = "d",
                            .meaning = "of clusters that of the circumscribed sphere",
                            .kept = Kept::once,
                            .columns = "radius|r"}),
    field(&Grains::mass, {.name = "mass",
                          .unit = "m",
                          .meaning = "mass",
                          .kept = Kept::once,
                          .columns = "mass|m",
                          .known = &Knowledge::masses}),
    field(&Grains::velocity, {.name = "velocity",
                              .unit = "d/tau_c",
                              .meaning = "of the centre of mass",
                              .shape = FieldShape::vector,
                              .columns = "vx vy vz|v_x v_y v_z|velocity_x velocity_y velocity_z",
                              .known = &Knowledge::velocities}),
    field(&Grains::spin,
          {.name = "spin",
           .unit = "1/tau_c",
           .meaning = "angular velocity; counter-clockwise is positive in the plane",
           .shape = FieldShape::rotation,
           .stored = "angular_velocity",
           .columns = "spin|omega|spin_x spin_y spin_z|wx wy wz|omegax omegay omegaz|omega_x omega_y omega_z",
           .known = &Knowledge::spins}),
    field(&Grains::angle, {.name = "angle",
                           .unit = "",
                           .meaning = "accumulated rotation, radians; 0 where it is not tracked",
                           .shape = FieldShape::rotation,
                           .columns = "angle|angle_x angle_y angle_z",
                           .known = &Knowledge::angles}),
    field(&Grains::shape, {.name = "shape",
                           .unit = "",
                           .meaning = "index of the grain's shape",
                           .presence = Presence::clusters,
                           .kept = Kept::once}),
    field(&Grains::scale, {.name = "scale",
                           .unit = "",
                           .meaning = "size factor of the whole body",
                           .presence = Presence::clusters,
                           .kept = Kept::once}),
    field(&Grains::orientation, {.name = "orientation",
                                 .unit = "",
                                 .meaning = "unit quaternion w, x, y, z from the shape's frame to the packing's",
                                 .shape = FieldShape::quaternion,
                                 .presence = Presence::clusters,
                                 .columns = "qw qx qy qz"}));

inline constexpr auto contact_fields = std::tuple(
    field(&Contacts::i, {.name = "i", .unit = "", .meaning = "index of the first grain", .columns = "id1"}),
    field(&Contacts::j,
          {.name = "j", .unit = "", .meaning = "index of the second grain, or -1 - w for wall w", .columns = "id2"}),
    field(&Contacts::normal_force, {.name = "normal_force",
                                    .unit = "m d/tau_c^2",
                                    .meaning = "positive where the two push each other",
                                    .stored = "fn",
                                    .columns = "fn"}),
    field(&Contacts::tangential_force, {.name = "tangential_force",
                                        .unit = "m d/tau_c^2",
                                        .meaning = "on i; perpendicular to the normal",
                                        .shape = FieldShape::vector,
                                        .stored = "ft",
                                        .columns = "ftx fty ftz",
                                        .known = &Knowledge::tangential_forces}),
    field(&Contacts::normal, {.name = "normal",
                              .unit = "",
                              .meaning = "unit vector from i to j",
                              .shape = FieldShape::vector,
                              .columns = "nx ny nz"}),
    field(&Contacts::point, {.name = "point",
                             .unit = "d",
                             .meaning = "middle of the overlap, at i (not at its periodic copy)",
                             .shape = FieldShape::vector,
                             .columns = "x y z"}),
    field(&Contacts::overlap, {.name = "overlap", .unit = "d", .meaning = "positive where the two touch"}),
    field(&Contacts::image, {.name = "image",
                             .unit = "",
                             .meaning = "the copy of j that touches is shifted by image_k times edge k of the cell",
                             .shape = FieldShape::image,
                             .columns = "sx sy sz"}),
    field(&Contacts::part_i,
          {.name = "part_i", .unit = "", .meaning = "arm of i; 0 for discs and spheres", .columns = "part1"}),
    field(&Contacts::part_j, {.name = "part_j",
                              .unit = "",
                              .meaning = "arm of j; of a wall the bead, or which end of i's arm",
                              .columns = "part2"}),
    field(&Contacts::sliding, {.name = "sliding",
                               .unit = "",
                               .meaning = "1 where the Coulomb limit is reached",
                               .stored = "slip",
                               .known = &Knowledge::sliding}));

inline constexpr auto wall_fields = std::tuple(
    field(&Wall::kind, {.name = "kind", .unit = "", .meaning = "0 plane, 1 row of beads, 2 cylinder"}),
    field(&Wall::position,
          {.name = "position",
           .unit = "d",
           .meaning = "a point of the plane, of the line through the bead centres, of the cylinder's axis",
           .shape = FieldShape::place}),
    field(&Wall::normal, {.name = "normal",
                          .unit = "",
                          .meaning = "unit vector into the domain; of a cylinder along its axis",
                          .shape = FieldShape::place}),
    field(&Wall::velocity,
          {.name = "velocity", .unit = "d/tau_c", .meaning = "of the whole wall", .shape = FieldShape::place}),
    field(&Wall::force, {.name = "force",
                         .unit = "m d/tau_c^2",
                         .meaning = "total force of the grains on the wall",
                         .shape = FieldShape::place}),
    field(&Wall::bead_radius,
          {.name = "bead_radius", .unit = "d", .meaning = "radius of a bead", .presence = Presence::beads}),
    field(&Wall::radius, {.name = "radius",
                          .unit = "d",
                          .meaning = "radius of the cylinder",
                          .presence = Presence::cylinder,
                          .stored = "cylinder_radius",
                          .later = true}),
    field(&Wall::role, {.name = "role", .unit = "", .meaning = "0 side, 1 floor, 2 lid", .later = true}),
    field(&Wall::beads, {.name = "beads",
                         .unit = "d",
                         .meaning = "centres of the beads of all walls; wall w has rows bead_offset[w] to "
                                    "bead_offset[w + 1] - 1",
                         .shape = FieldShape::place,
                         .presence = Presence::beads,
                         .stored = "bead"}));

inline constexpr auto shape_fields = std::tuple(
    field(&ClusterShape::name, {.name = "name", .unit = "", .meaning = "of the shape"}),
    field(&ClusterShape::volume, {.name = "volume", .unit = "d^3", .meaning = "of the union of the arms"}),
    field(&ClusterShape::surface, {.name = "surface", .unit = "d^2", .meaning = "of the union of the arms"}),
    field(&ClusterShape::area, {.name = "area", .unit = "d^2", .meaning = "of the shadow along z"}),
    field(&ClusterShape::length, {.name = "length", .unit = "d", .meaning = "of the longest arm, tip to tip"}),
    field(&ClusterShape::circumradius,
          {.name = "circumradius", .unit = "d", .meaning = "from the centre of mass to the farthest point"}),
    field(&ClusterShape::inertia,
          {.name = "inertia", .unit = "d^5", .meaning = "principal moments at density 1", .shape = FieldShape::place}));

inline constexpr auto arm_fields =
    std::tuple(field(&Arm::centre, {.name = "centre",
                                    .unit = "d",
                                    .meaning = "in the shape's frame",
                                    .shape = FieldShape::place,
                                    .stored = "arm_centre"}),
               field(&Arm::direction, {.name = "direction",
                                       .unit = "",
                                       .meaning = "unit vector along the axis",
                                       .shape = FieldShape::place,
                                       .stored = "arm_direction"}),
               field(&Arm::half_length,
                     {.name = "half_length", .unit = "d", .meaning = "of the axis", .stored = "arm_half_length"}),
               field(&Arm::radius, {.name = "radius", .unit = "d", .meaning = "radius", .stored = "arm_radius"}));

/// The components of a value that count, out of those it has.
struct Components {
  int first, count;
};

constexpr Components components(FieldShape shape, int dimension) {
  switch (shape) {
    case FieldShape::scalar:
      return {0, 1};
    case FieldShape::vector:
    case FieldShape::image:
      return {0, dimension};
    case FieldShape::rotation:
      return dimension == 2 ? Components{2, 1} : Components{0, 3};
    case FieldShape::quaternion:
      return {0, 4};
    case FieldShape::place:
      return {0, 3};
  }
  return {0, 1};
}

// Component k of a value, of any type that a field has.

template <class T>
requires std::is_arithmetic_v<T>
constexpr T& component(T& value, int) { return value; }
template <class T>
requires std::is_arithmetic_v<T>
constexpr T component(const T& value, int) { return value; }
constexpr double& component(Vec3& v, int k) { return v[k]; }
constexpr double component(const Vec3& v, int k) { return v[k]; }
constexpr std::int8_t& component(std::array<std::int8_t, 3>& v, int k) { return v[static_cast<std::size_t>(k)]; }
constexpr std::int8_t component(const std::array<std::int8_t, 3>& v, int k) { return v[static_cast<std::size_t>(k)]; }
constexpr double& component(Quaternion& q, int k) { return k == 0 ? q.w : k == 1 ? q.x : k == 2 ? q.y : q.z; }
constexpr double component(const Quaternion& q, int k) { return k == 0 ? q.w : k == 1 ? q.x : k == 2 ? q.y : q.z; }

/// The number type of the components of T.
template <class T>
using Number = std::remove_cvref_t<decltype(component(std::declval<const T&>(), 0))>;

/// How many components a value has in memory.
template <class T>
constexpr int component_count() {
  return std::is_arithmetic_v<T> ? 1 : std::is_same_v<T, Quaternion> ? 4 : 3;
}

}  // namespace jam
