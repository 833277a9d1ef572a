#include "jamscape/study/verify.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <utility>
#include <vector>

namespace jam {
namespace {

Packing packing() {
  Packing p;
  p.dimension = 3;
  p.relaxation = "energy";
  p.shapes.push_back({"cross", {}, 1, 1, 1, {1, 1, 1}, 1, 1});
  Grains& g = p.grains;
  g.id = {1, 2}, g.species = {0, 1}, g.radius = {1, 1}, g.mass = {1, 1}, g.shape = {0, 0}, g.scale = {1, 1};
  g.position = g.velocity = g.spin = g.angle = {Vec3{}, Vec3{1, 0, 0}};
  g.orientation = {{1, 0, 0, 0}, {1, 0, 0, 0}};
  Contacts& c = p.contacts;
  c.i = {0}, c.j = {1}, c.part_i = {0}, c.part_j = {0}, c.image = {{0, 0, 0}}, c.overlap = {.1}, c.normal_force = {1};
  c.normal = c.tangential_force = c.point = {Vec3{1, 0, 0}};
  c.sliding = {0};
  p.walls.push_back({WallKind::beads, {}, {1, 0, 0}, {}, {}, 1, {Vec3{}}, 0});
  return p;
}

/// Every member that is stored, and what its change is called.
TEST(FirstDifference, NamesWhateverDiffers) {
  const std::vector<std::pair<const char*, std::function<void(Packing&)>>> changes = {
      {"time", [](Packing& p) { p.step = 1; }},
      {"time", [](Packing& p) { p.time = 1; }},
      {"time", [](Packing& p) { p.dimension = 2; }},
      {"packing_fraction", [](Packing& p) { p.packing_fraction = 1; }},
      {"packing_fraction_plain", [](Packing& p) { p.packing_fraction_plain = 1; }},
      {"relaxation", [](Packing& p) { p.relaxation = "budget"; }},
      {"domain", [](Packing& p) { p.domain.lo[1] = 1; }},
      {"domain", [](Packing& p) { p.domain.hi[1] = 1; }},
      {"domain", [](Packing& p) { p.domain.periodic[2] = true; }},
      {"grains.id", [](Packing& p) { p.grains.id[1] = 7; }},
      {"grains.species", [](Packing& p) { p.grains.species[1] = 7; }},
      {"grains.radius", [](Packing& p) { p.grains.radius[1] = 7; }},
      {"grains.mass", [](Packing& p) { p.grains.mass[1] = 7; }},
      {"grains.position", [](Packing& p) { p.grains.position[1][2] = -0.0; }},
      {"grains.velocity", [](Packing& p) { p.grains.velocity[1][2] = 7; }},
      {"grains.spin", [](Packing& p) { p.grains.spin[1][2] = 7; }},
      {"grains.angle", [](Packing& p) { p.grains.angle[1][2] = 7; }},
      {"grains.shape", [](Packing& p) { p.grains.shape[1] = 1; }},
      {"grains.scale", [](Packing& p) { p.grains.scale[1] = 2; }},
      {"grains.orientation", [](Packing& p) { p.grains.orientation[1].x = -0.0; }},
      {"shapes", [](Packing& p) { p.shapes[0].volume = 2; }},
      {"contacts.pairs", [](Packing& p) { p.contacts.i[0] = 1; }},
      {"contacts.pairs", [](Packing& p) { p.contacts.j[0] = -1; }},
      {"contacts.parts", [](Packing& p) { p.contacts.part_i[0] = 1; }},
      {"contacts.parts", [](Packing& p) { p.contacts.part_j[0] = 1; }},
      {"contacts.image", [](Packing& p) { p.contacts.image[0][1] = -1; }},
      {"contacts.overlap", [](Packing& p) { p.contacts.overlap[0] = .2; }},
      {"contacts.normal", [](Packing& p) { p.contacts.normal[0][1] = 1e-300; }},
      {"contacts.normal_force", [](Packing& p) { p.contacts.normal_force[0] = 2; }},
      {"contacts.tangential_force", [](Packing& p) { p.contacts.tangential_force[0][0] = 2; }},
      {"contacts.point", [](Packing& p) { p.contacts.point[0][0] = 2; }},
      {"contacts.sliding", [](Packing& p) { p.contacts.sliding[0] = 1; }},
      {"walls", [](Packing& p) { p.walls[0].kind = WallKind::plane; }},
      {"walls", [](Packing& p) { p.walls[0].force[0] = 2; }},
      {"walls", [](Packing& p) { p.walls[0].velocity[0] = 2; }},
      {"walls", [](Packing& p) { p.walls[0].beads[0][0] = 2; }},
      {"walls", [](Packing& p) { p.walls.clear(); }},
      {"energy", [](Packing& p) { p.energy.kinetic = 2; }},
      {"energy", [](Packing& p) { p.energy.elastic = 2; }},
      {"energy", [](Packing& p) { p.energy.damped = 2; }},
      {"energy", [](Packing& p) { p.energy.rubbed = 2; }},
      {"energy", [](Packing& p) { p.energy.wall_work = 2; }},
      {"energy", [](Packing& p) { p.energy.gravity_work = 2; }},
  };
  EXPECT_EQ(first_difference(packing(), packing()), "");
  for (const auto& [name, change] : changes) {
    Packing other = packing();
    change(other);
    EXPECT_EQ(first_difference(packing(), other), name);
  }
}

}  // namespace
}  // namespace jam
