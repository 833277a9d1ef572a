// Packings with known answers.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "jamscape/base/random.hpp"
#include "jamscape/packing/wall_roles.hpp"

namespace jam::test {

inline Packing box(int dimension, Vec3 side, bool periodic = false) {
  Packing p;
  p.dimension = dimension;
  p.domain.hi = side;
  for (int a = 0; a < dimension; ++a) p.domain.periodic[static_cast<std::size_t>(a)] = periodic;
  return p;
}

inline void add_grain(Packing& p, Vec3 x, double radius = 0.5) {
  Grains& g = p.grains;
  g.id.push_back(static_cast<std::int64_t>(g.size()));
  g.species.push_back(0);
  g.radius.push_back(radius);
  g.mass.push_back(1);
  g.position.push_back(x);
  g.velocity.push_back({});
  g.spin.push_back({});
  g.angle.push_back({});
}

/// A cluster of the packing's shape of this index.
inline void add_body(Packing& p, Vec3 x, std::int32_t shape = 0, double scale = 1, Quaternion turn = {}) {
  const ClusterShape& s = p.shapes[static_cast<std::size_t>(shape)];
  add_grain(p, x, scale * s.circumradius);
  p.grains.mass.back() = scale * scale * scale * s.volume;
  p.grains.shape.push_back(shape);
  p.grains.scale.push_back(scale);
  p.grains.orientation.push_back(turn);
}

/// A contact at a point, of the parts given; wall forces are kept.
inline void add_contact_at(Packing& p, std::uint32_t i, std::int32_t j, Vec3 point, Vec3 normal, double force,
                           Vec3 tangential = {}, std::uint16_t part_i = 0, std::uint16_t part_j = 0) {
  Contacts& k = p.contacts;
  k.i.push_back(i);
  k.j.push_back(j);
  k.part_i.push_back(part_i);
  k.part_j.push_back(part_j);
  k.image.push_back({});
  k.overlap.push_back(0.01);
  k.normal_force.push_back(force);
  k.normal.push_back(normal);
  k.tangential_force.push_back(tangential);
  k.point.push_back(point);
  k.sliding.push_back(0);
  if (j < 0) p.walls[static_cast<std::size_t>(-1 - j)].force += force * normal - tangential;
}

/// A cylinder along y around the box's middle, then floor and lid; the box around it is given.
inline void add_cylinder(Packing& p) {
  Wall side;
  side.kind = WallKind::cylinder;
  side.position = 0.5 * (p.domain.lo + p.domain.hi);
  side.normal = {0, 1, 0};
  side.radius = 0.5 * (p.domain.hi[0] - p.domain.lo[0]);
  Wall floor, lid;
  floor.position = p.domain.lo;
  floor.normal = {0, 1, 0};
  lid.position = p.domain.hi;
  lid.normal = {0, -1, 0};
  p.walls = {side, floor, lid};
  give_roles(p, 1);
}

/// A contact with given forces; the geometry follows from the grains (or, for a wall, from its position and normal).
inline void add_contact(Packing& p, std::uint32_t i, std::int32_t j, double force, Vec3 tangential = {},
                        std::array<std::int8_t, 3> image = {}) {
  Contacts& k = p.contacts;
  const Vec3 xi = p.grains.position[i];
  const double ri = p.grains.radius[i];
  Vec3 n{};
  double overlap = 0;
  if (j >= 0) {
    Vec3 xj = p.grains.position[static_cast<std::size_t>(j)];
    for (int a = 0; a < 3; ++a) xj[a] += image[static_cast<std::size_t>(a)] * (p.domain.hi[a] - p.domain.lo[a]);
    const double r = norm(xj - xi);
    n = (1 / r) * (xj - xi);
    overlap = ri + p.grains.radius[static_cast<std::size_t>(j)] - r;
  } else {
    const Wall& w = p.walls[static_cast<std::size_t>(-1 - j)];
    n = -1.0 * w.normal;
    overlap = ri - dot(xi - w.position, w.normal);
  }
  if (std::abs(overlap) < 1e-12) overlap = 0;
  k.i.push_back(i);
  k.j.push_back(j);
  k.part_i.push_back(0);
  k.part_j.push_back(0);
  k.image.push_back(image);
  k.overlap.push_back(overlap);
  k.normal_force.push_back(force);
  k.normal.push_back(n);
  k.tangential_force.push_back(tangential);
  k.point.push_back(xi + (j >= 0 ? ri - overlap / 2 : ri - overlap) * n);
  k.sliding.push_back(0);
  if (j < 0) p.walls[static_cast<std::size_t>(-1 - j)].force += force * n - tangential;
}

/// Flat walls on every side, in the order x lo, x hi, y lo, ...
inline void add_walls(Packing& p) {
  for (int a = 0; a < p.dimension; ++a)
    for (const double sign : {1.0, -1.0}) {
      Wall w;
      w.position = sign > 0 ? p.domain.lo : p.domain.hi;
      w.normal[a] = sign;
      p.walls.push_back(w);
    }
  give_roles(p, p.dimension - 1);
}

/// All contacts of touching bodies (overlap >= -1e-9), force = 1 + 10 overlap, sorted; nearest image in periodic boxes.
inline void touch(Packing& p) {
  const auto n = static_cast<std::uint32_t>(p.grains.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::int32_t w = static_cast<std::int32_t>(p.walls.size()); w-- > 0;) {
      const Wall& wall = p.walls[static_cast<std::size_t>(w)];
      const double overlap = p.grains.radius[i] - dot(p.grains.position[i] - wall.position, wall.normal);
      if (overlap >= -1e-9) add_contact(p, i, -1 - w, 1 + 10 * overlap);
    }
    for (std::uint32_t j = i + 1; j < n; ++j) {
      Vec3 d = p.grains.position[j] - p.grains.position[i];
      std::array<std::int8_t, 3> image{};
      for (int a = 0; a < 3; ++a)
        if (p.domain.periodic[static_cast<std::size_t>(a)]) {
          const double side = p.domain.hi[a] - p.domain.lo[a];
          image[static_cast<std::size_t>(a)] = static_cast<std::int8_t>(-std::lround(d[a] / side));
          d[a] += image[static_cast<std::size_t>(a)] * side;
        }
      const double overlap = p.grains.radius[i] + p.grains.radius[j] - norm(d);
      if (overlap >= -1e-9) add_contact(p, i, static_cast<std::int32_t>(j), 1 + 10 * std::max(overlap, 0.0), {}, image);
    }
  }
}

/// nx x ny grains of diameter 1, rows along x, in a periodic box that continues the lattice (ny even for hexagons).
inline Packing hexagonal(int nx, int ny) {
  const double h = std::sqrt(0.75);
  Packing p = box(2, {static_cast<double>(nx), ny * h, 0}, true);
  for (int y = 0; y < ny; ++y)
    for (int x = 0; x < nx; ++x) add_grain(p, {x + (y % 2) * 0.5 + 0.1, y * h + 0.1, 0});
  touch(p);
  return p;
}

inline Packing square(int nx, int ny) {
  Packing p = box(2, {static_cast<double>(nx), static_cast<double>(ny), 0}, true);
  for (int y = 0; y < ny; ++y)
    for (int x = 0; x < nx; ++x) add_grain(p, {x + 0.5, y + 0.5, 0});
  touch(p);
  return p;
}

/// Points without any order; radius .5, no contacts.
inline Packing ideal_gas(int dimension, Vec3 side, int count, bool periodic, std::uint64_t seed = 1) {
  Packing p = box(dimension, side, periodic);
  Random random(seed, "ideal gas", 0, "positions");
  for (int k = 0; k < count; ++k) {
    Vec3 x{};
    for (int a = 0; a < dimension; ++a) x[a] = random.uniform(0, side[a]);
    add_grain(p, x);
  }
  return p;
}

/// Points without any order in a cylinder of this diameter along y, between floor and lid.
inline Packing ideal_gas_in_cylinder(double diameter, double height, int count, std::uint64_t seed = 1) {
  Packing p = box(3, {diameter, height, diameter});
  add_cylinder(p);
  Random random(seed, "ideal gas", 0, "cylinder");
  const double r = diameter / 2;
  while (p.grains.size() < static_cast<std::size_t>(count)) {
    const Vec3 x{random.uniform(0, diameter), random.uniform(0, height), random.uniform(0, diameter)};
    if ((x[0] - r) * (x[0] - r) + (x[2] - r) * (x[2] - r) < r * r) add_grain(p, x);
  }
  return p;
}

/// Six grains of diameter 1, each touching all but the one opposite, equal forces: hollow, one void.
inline Packing octahedron() {
  Packing p = box(3, {4, 4, 4});
  const double r = std::sqrt(0.5);
  for (int a = 0; a < 3; ++a)
    for (const double sign : {1.0, -1.0}) {
      Vec3 x{2, 2, 2};
      x[a] += sign * r;
      add_grain(p, x);
    }
  touch(p);
  for (double& f : p.contacts.normal_force) f = 1;
  return p;
}

/// Four grains of diameter 1, all touching, equal forces: filled, no void.
inline Packing tetrahedron() {
  Packing p = box(3, {4, 4, 4});
  const double h = std::sqrt(0.125);
  for (const Vec3 x : {Vec3{h, h, h}, Vec3{h, -h, -h}, Vec3{-h, h, -h}, Vec3{-h, -h, h}})
    add_grain(p, Vec3{2, 2, 2} + x);
  touch(p);
  for (double& f : p.contacts.normal_force) f = 1;
  return p;
}

/// A small jammed-looking packing between flat walls: a random cloud of overlapping grains with random forces.
inline Packing cloud(int dimension, int count, std::uint64_t seed) {
  const double side = std::pow(count * 0.7, 1.0 / dimension);
  Packing p = ideal_gas(dimension, {side, side, dimension == 3 ? side : 0}, count, false, seed);
  add_walls(p);
  touch(p);
  Random random(seed, "cloud", 0, "forces");
  for (double& f : p.contacts.normal_force) f = -std::log(1 - random.uniform());
  p.packing_fraction = 0.8;
  return p;
}

}  // namespace jam::test
