#include "jamscape/protocol/cluster_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "jamscape/base/error.hpp"
#include "jamscape/base/random.hpp"
#include "jamscape/contact/damping.hpp"
#include "jamscape/protocol/random_places.hpp"
#include "jamscape/protocol/start.hpp"

namespace jam {
namespace {

/// A square lattice of across x deep sites, centred; those whose cell leaves the cylinder are left out.
std::vector<Vec3> square_sites(const ClusterRoom& room, std::int64_t across, std::int64_t deep) {
  std::vector<Vec3> sites;
  for (std::int64_t a = 0; a < across; ++a)
    for (std::int64_t b = 0; b < deep; ++b) {
      const double x = (static_cast<double>(a) - static_cast<double>(across - 1) / 2) * room.pitch;
      const double z = (static_cast<double>(b) - static_cast<double>(deep - 1) / 2) * room.pitch;
      const bool inside = std::hypot(x, z) + room.pitch / 2 < room.container.width / 2 + 1e-9;
      if (room.container.walls != WallModel::cylinder || inside || across == 1) sites.push_back({x, 0, z});
    }
  return sites;
}

/// Sites of one layer of the lattice: as many as there is room for, at least one.
std::vector<Vec3> layer_sites(const ClusterRoom& room) {
  const Container& c = room.container;
  const auto fitting = [&](double width) {
    return static_cast<std::int64_t>(std::max(1.0, std::floor(width / room.pitch + 1e-9)));
  };
  const std::int64_t across = fitting(c.width);
  if (c.walls != WallModel::cylinder) return square_sites(room, across, c.dimension == 2 ? 1 : fitting(c.thickness));
  std::vector<Vec3> even = square_sites(room, across, across);
  std::vector<Vec3> odd =
      square_sites(room, std::max<std::int64_t>(across - 1, 1), std::max<std::int64_t>(across - 1, 1));
  return odd.size() > even.size() ? odd : even;
}

std::int64_t layers(std::size_t bodies, std::size_t per_layer) {
  return static_cast<std::int64_t>((bodies + per_layer - 1) / per_layer);
}

std::vector<ClusterWall> walls(const Container& c, double height) {
  std::vector<ClusterWall> walls;
  const auto plane = [&](int axis, double low, double high) {
    walls.push_back({.axis = axis, .high = false, .position = low});
    walls.push_back({.axis = axis, .high = true, .position = high});
  };
  if (c.walls == WallModel::cylinder)
    walls.push_back({.kind = WallKind::cylinder, .axis = 1, .radius = c.width / 2});
  else
    plane(0, -c.width / 2, c.width / 2);
  if (c.dimension == 3 && c.walls == WallModel::box) plane(2, -c.thickness / 2, c.thickness / 2);
  plane(1, 0, height);
  return walls;
}

}  // namespace

ClusterRoom cluster_room(const SystemOptions& system, const TaskKey& key) {
  ClusterRoom room;
  room.shape = grain_shape(system);
  room.scales = draw_diameters(system.grains, key);
  room.container = container(system, room.shape, room.scales);
  const double largest = *std::max_element(room.scales.begin(), room.scales.end());
  room.pitch = 2 * room.shape.circumradius * largest + system.start.gap;
  if (system.start.layout == StartLayout::random)
    room.height = room.container.bodies / (room.container.base() * system.start.packing_fraction);
  else
    room.height = room.pitch * static_cast<double>(layers(room.scales.size(), layer_sites(room).size()));
  return room;
}

std::vector<Vec3> lattice_sites(const ClusterRoom& room, std::size_t count) {
  const std::vector<Vec3> layer = layer_sites(room);
  std::vector<Vec3> sites;
  for (std::size_t k = 0; k < count; ++k) {
    Vec3 x = layer[k % layer.size()];
    x[1] = (static_cast<double>(k / layer.size()) + 0.5) * room.pitch;
    sites.push_back(x);
  }
  return sites;
}

ClusterSetup cluster_start(const SystemOptions& system, const TaskKey& key, const ClusterRoom& room) {
  const int D = room.container.dimension;
  ClusterSetup setup;
  setup.shapes = {room.shape};
  setup.density = system.grains.density;
  setup.planar = D == 2;
  setup.walls = walls(room.container, room.height);
  setup.gravity = {0, -system.domain.gravity, 0};
  setup.kind = system.contact.law;
  const double mass = system.grains.density * room.shape.volume;
  setup.grain_law = grain_law(system.contact, mass);
  setup.wall_law = wall_law(system.contact, mass);
  setup.dt = system.integrator.step;
  setup.parallel = system.clusters.parallel;
  setup.parallel_angle = system.clusters.parallel_angle * std::numbers::pi / 180;
  setup.duplicates = system.clusters.duplicates;

  ClusterBodies& bodies = setup.bodies;
  bodies.scale = room.scales;
  bodies.shape.assign(room.scales.size(), 0);
  Random places(key.seed, key.system, key.realisation, "places");
  if (system.start.layout == StartLayout::random) {
    place_at_random(room, places, bodies);
  } else {
    bodies.position = lattice_sites(room, room.scales.size());
    for (std::size_t k = 0; k < room.scales.size(); ++k) bodies.orientation.push_back(random_orientation(places, D));
  }
  Random random(key.seed, key.system, key.realisation, "velocities");
  const double speed = system.start.speed;
  const bool in_plane = D == 2 || (room.container.walls == WallModel::box && system.domain.thickness == 1);
  for (std::size_t k = 0; k < room.scales.size(); ++k) {
    Vec3 v{random.uniform(-speed, speed), random.uniform(-speed, speed), 0};
    if (!in_plane) v[2] = random.uniform(-speed, speed);
    bodies.velocity.push_back(v);
    bodies.spin.push_back({});
  }
  return setup;
}

}  // namespace jam
