#include "jamscape/protocol/start.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "jamscape/base/error.hpp"
#include "jamscape/base/random.hpp"
#include "jamscape/contact/damping.hpp"
#include "jamscape/protocol/container.hpp"

namespace jam {
namespace {

constexpr double bead_radius = 0.5;

double small_diameter(const GrainOptions& o) { return 1 / (o.small_fraction + (1 - o.small_fraction) * o.size_ratio); }

double ball(int dimension) { return dimension == 2 ? std::numbers::pi / 4 : std::numbers::pi / 6; }

double smallest_diameter(const GrainOptions& o) {
  switch (o.sizes) {
    case SizeLaw::monodisperse:
      return 1;
    case SizeLaw::uniform:
      return 1 - o.width / 2;
    case SizeLaw::bidisperse:
      return small_diameter(o);
  }
  return 1;
}

/// Places of the beads along a row of a box of side `length`, from 0 in one corner to `length` in the next.
///
/// Rows that are no frame stick out beyond the corners of the box at its widest. A frame has a bead in each corner, and
/// its next beads, at s from the corner along both walls, decide what may be caught there: discs of radius r at the
/// touching distance R = r + 1/2 from both. They fit between them only for R < s/sqrt(2); for R = .9 s they see them at
/// an angle of 103 degrees, which friction below .79 lets go of, and at less as s shrinks. So s <= R/.9 at the start.
/// Of R > 1.58 s they rest on the second beads, at up to 127 degrees.
std::vector<double> along_row(double length, const SystemOptions& system) {
  std::vector<double> row;
  if (system.domain.bead_rows == BeadRows::framed) {
    const double spacing = std::min(1.0, (bead_radius + smallest_diameter(system.grains) / 2) / 0.9);
    const auto gaps = static_cast<int>(std::ceil(length / spacing));
    for (int k = 0; k < gaps; ++k) row.push_back(length * k / gaps);
    row.push_back(length);
  } else {
    for (double at = system.domain.bead_phase - 2; at < length + 2; at += 1) row.push_back(at);
  }
  return row;
}

/// Rows of touching beads along both ends of both axes.
std::vector<EngineWall<2>> bead_walls(double length, const SystemOptions& system) {
  const std::vector<double> row = along_row(length, system);
  std::vector<EngineWall<2>> walls;
  for (int axis = 0; axis < 2; ++axis)
    for (const bool high : {false, true}) {
      EngineWall<2> wall;
      wall.kind = WallKind::beads;
      wall.axis = axis;
      wall.high = high;
      wall.position = high ? length : 0.0;
      wall.bead_radius = bead_radius;
      for (const double at : row) {
        Vec2 bead;
        bead[axis] = wall.position;
        bead[1 - axis] = at;
        wall.beads.push_back(bead);
        if (system.domain.bead_rows != BeadRows::rigid) wall.along.push_back(at / length - 0.5);
      }
      walls.push_back(wall);
    }
  return walls;
}

template <int D>
std::vector<EngineWall<D>> planes(double length) {
  std::vector<EngineWall<D>> walls;
  for (int axis = 0; axis < D; ++axis)
    for (const bool high : {false, true}) walls.push_back({WallKind::plane, axis, high, high ? length : 0.0, 0, 0, {}});
  return walls;
}

/// A periodic box has no wall to take up the momentum of the start: without this it would keep it for ever.
template <int D>
void stop_drift(EngineSetup<D>& setup) {
  Vec<D> momentum{};
  double mass = 0;
  for (std::size_t k = 0; k < setup.mass.size(); ++k)
    momentum += setup.mass[k] * setup.velocity[k], mass += setup.mass[k];
  for (Vec<D>& v : setup.velocity) v -= (1 / mass) * momentum;
}

}  // namespace

std::vector<double> draw_diameters(const GrainOptions& o, const TaskKey& key) {
  std::vector<double> d(static_cast<std::size_t>(o.count), 1.0);
  Random random(key.seed, key.system, key.realisation, "sizes");
  if (o.sizes == SizeLaw::uniform) {
    for (double& a : d) a = 1 + o.width * (random.uniform() - 0.5);
  } else if (o.sizes == SizeLaw::bidisperse) {
    const double small = small_diameter(o);
    const auto count = static_cast<std::size_t>(std::llround(o.small_fraction * static_cast<double>(o.count)));
    for (std::size_t k = 0; k < d.size(); ++k) d[k] = k < count ? small : small * o.size_ratio;
    for (std::size_t k = d.size(); k > 1; --k) std::swap(d[k - 1], d[random.below(k)]);
  }
  return d;
}

double mean_power(const GrainOptions& o, int power) {
  switch (o.sizes) {
    case SizeLaw::monodisperse:
      return 1;
    case SizeLaw::uniform: {
      if (o.width == 0) return 1;
      const double a = 1 - o.width / 2, b = 1 + o.width / 2;
      return (std::pow(b, power + 1) - std::pow(a, power + 1)) / ((power + 1) * (b - a));
    }
    case SizeLaw::bidisperse: {
      const double small = small_diameter(o);
      return o.small_fraction * std::pow(small, power) + (1 - o.small_fraction) * std::pow(small * o.size_ratio, power);
    }
  }
  return 1;
}

StartBox start_box(const SystemOptions& system, const std::vector<double>& diameters) {
  const int D = static_cast<int>(system.domain.dimension);
  StartBox box;
  box.measure = {D, system.domain.walls, system.domain.box, 0, 0};
  double largest = 0;
  for (const double d : diameters) {
    box.measure.plain += ball(D) * std::pow(d, D);
    largest = std::max(largest, d);
  }
  box.measure.grains = system.domain.area == AreaConvention::nominal ? ball(D) * static_cast<double>(diameters.size())
                                                                     : box.measure.plain;
  while (std::pow(static_cast<double>(box.per_side), D) < static_cast<double>(diameters.size()) - 0.5) ++box.per_side;
  const double closest = largest + system.start.gap, sites = static_cast<double>(box.per_side);
  const double wanted = box.measure.length(system.start.packing_fraction);
  if (system.domain.walls == WallModel::periodic) {
    box.length = std::max(wanted, sites * closest);
    box.spacing = box.length / sites;
    box.margin = box.spacing / 2;
  } else {
    box.margin = largest / 2 + system.start.gap + (system.domain.walls == WallModel::beads ? bead_radius : 0.0);
    box.length = std::max(wanted, (sites - 1) * closest + 2 * box.margin);
    box.spacing = box.per_side > 1 ? (box.length - 2 * box.margin) / (sites - 1) : 0;
  }
  return box;
}

void check_start(const SystemOptions& system) {
  if (system.contact.spring_turn == SpringTurn::twirled && engine_of(system) != EngineKind::spheres)
    throw usage_error("contact.spring_turn: only springs of spheres in three dimensions can be twirled", {},
                      system.domain.dimension == 2 ? "leave it out: in two dimensions springs turn with the contact"
                                                   : "leave it out: springs of clusters are projected");
  if (system.contact.damping == DampingRule::printed || system.contact.damping_ratio >= 0) {  // others always can be
    grain_law(system.contact, 1.0);
    wall_law(system.contact, 1.0);
  }
  if (has_lid(system.domain.walls)) {
    if (engine_of(system) == EngineKind::clusters) return;
    refuse_balls();
  }
  if (system.domain.dimension == 3 && system.domain.walls == WallModel::beads)
    throw usage_error("domain.walls: bead walls are for two dimensions", {}, "domain.walls = \"flat\" or \"periodic\"");
  if (system.domain.walls == WallModel::beads && system.domain.bead_rows == BeadRows::framed &&
      system.domain.bead_phase != 0)
    throw usage_error("domain.bead_phase: the rows of a frame begin in its corners and cannot be shifted", {},
                      "domain.bead_phase = 0, or domain.bead_rows = \"closing\"");
  if (system.domain.walls == WallModel::periodic && system.domain.gravity != 0)
    throw usage_error("domain.gravity: in a periodic box grains fall for ever", {},
                      "domain.gravity = 0, or walls: domain.walls = \"flat\", or a container");
  if (system.grains.shape != BodyShape::ball)
    throw usage_error("grains.shape: clusters are for containers", {}, "domain.walls = \"box\" or \"cylinder\"");
}

template <int D>
EngineSetup<D> start(const SystemOptions& system, const TaskKey& key) {
  check_start(system);
  const std::vector<double> diameters = draw_diameters(system.grains, key);
  const StartBox box = start_box(system, diameters);
  EngineSetup<D> setup;
  setup.kind = system.contact.law;
  setup.grain_law = grain_law(system.contact, 1.0);
  setup.wall_law = wall_law(system.contact, 1.0);
  setup.spring_turn = system.contact.spring_turn;
  setup.scheme = system.integrator.scheme;
  setup.dt = system.integrator.step;
  setup.gravity[1] = -system.domain.gravity;
  if (system.domain.walls == WallModel::periodic)
    setup.box.length.fill(box.length);
  else if constexpr (D == 2)
    setup.walls = system.domain.walls == WallModel::beads ? bead_walls(box.length, system) : planes<D>(box.length);
  else
    setup.walls = planes<D>(box.length);

  Random random(key.seed, key.system, key.realisation, "velocities");
  const double mean = mean_power(system.grains, D), speed = system.start.speed;
  for (std::size_t k = 0; k < diameters.size(); ++k) {
    const double r = diameters[k] / 2, m = std::pow(diameters[k], D) / mean;
    setup.radius.push_back(r);
    setup.mass.push_back(m);
    setup.inertia.push_back(inertia_factor(system) * m * r * r);
    setup.species.push_back(system.grains.sizes == SizeLaw::bidisperse && diameters[k] > 1 ? 1 : 0);
    Vec<D> x, v;
    std::size_t site = k;
    for (int c = 0; c < D; ++c, site /= static_cast<std::size_t>(box.per_side))
      x[c] = box.margin + static_cast<double>(site % static_cast<std::size_t>(box.per_side)) * box.spacing;
    for (int c = 0; c < D; ++c) v[c] = random.uniform(-speed, speed);
    setup.position.push_back(x);
    setup.velocity.push_back(v);
  }
  if (system.domain.walls == WallModel::periodic) stop_drift(setup);
  return setup;
}

template EngineSetup<2> start<2>(const SystemOptions&, const TaskKey&);
template EngineSetup<3> start<3>(const SystemOptions&, const TaskKey&);

}  // namespace jam
