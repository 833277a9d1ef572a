// The packing in data/v1-run.h5 and data/v1-frame.h5.
#pragma once

#include "jamscape/packing/packing.hpp"

namespace jam::testing {

/// A small packing of plain fractions, the same with every compiler and library.
inline Packing plain_packing(int dimension, int frame) {
  int drawn = 10 * frame;
  const auto number = [&] { return ++drawn / 7.0; };
  const auto vec = [&] { return Vec3{number(), -number(), dimension == 2 ? 0 : number()}; };
  Packing p;
  p.dimension = dimension;
  p.step = 100 + frame;
  p.time = number();
  p.stage = "compress";
  p.packing_fraction = number();
  p.packing_fraction_plain = number();
  p.domain = {vec(), vec(), {false, true, false}};
  for (int n = 0; n < 3 + frame; ++n) {
    Grains& g = p.grains;
    g.id.push_back(2 * n);
    g.species.push_back(n % 2);
    g.radius.push_back(number());
    g.mass.push_back(number());
    for (auto* vectors : {&g.position, &g.velocity}) vectors->push_back(vec());
    for (auto* turns : {&g.spin, &g.angle}) turns->push_back({0, 0, number()});
  }
  Contacts& c = p.contacts;
  for (int m = 0; m < 2; ++m) {
    c.i.push_back(static_cast<std::uint32_t>(m));
    c.j.push_back(m == 0 ? 2 : -1);
    c.part_i.push_back(0);
    c.part_j.push_back(static_cast<std::uint16_t>(m));
    c.image.push_back({static_cast<std::int8_t>(m), 0, 0});
    c.overlap.push_back(number());
    c.normal_force.push_back(number());
    for (auto* vectors : {&c.normal, &c.tangential_force, &c.point}) vectors->push_back(vec());
    c.sliding.push_back(1);
  }
  Wall wall;
  wall.kind = WallKind::beads;
  for (Vec3* v : {&wall.position, &wall.normal, &wall.velocity, &wall.force}) *v = vec();
  wall.bead_radius = number();
  wall.beads = {vec(), vec()};
  wall.role = WallRole::lid;  // as the last wall of a file that does not say
  p.walls = {wall};
  p.energy = {number(), number(), number(), number(), number(), number()};
  return p;
}

}  // namespace jam::testing
