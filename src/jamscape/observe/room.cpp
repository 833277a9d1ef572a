#include "jamscape/observe/room.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "jamscape/base/border.hpp"
#include "jamscape/base/error.hpp"
#include "jamscape/observe/box.hpp"

namespace jam {

Room::Room(const Packing& packing, double layer)
    : dimension_(packing.dimension),
      cell_(reduced(packing.domain, packing.dimension)),
      faces_(cell_, packing.dimension) {
  double bead = 0;
  for (const Wall& w : packing.walls) bead = std::max(bead, w.bead_radius);
  layer_ = layer + bead;
  if (const Wall* cylinder = find_cylinder(packing)) {
    axis_ = wall_axis(*cylinder, dimension_);
    if (!cell_.upright()) throw data_error("a cylinder stands in an upright cell, and this one is tilted");
    centre_ = cylinder->position;
    radius_ = cylinder->radius;
  }
}

Room::Place Room::place(const Vec3& x) const {
  Place p{true, std::numeric_limits<double>::infinity()};
  const auto keep_from = [&](double wall, double away, double size) {
    p.inside = p.inside && reaches(wall, away, size);
    p.reach = std::min(p.reach, wall - layer_);
  };
  for (int a = 0; a < dimension_; ++a) {
    if (periodic(a))
      p.reach = std::min(p.reach, period(a) / 2);
    else if (walled(a) && a != thin)
      keep_from(std::min(above_low(a, x), below_high(a, x)), margin[a], width(a));
  }
  if (round()) {
    Vec3 out = x - centre_;
    out[axis_] = 0;
    keep_from(radius_ - norm(out), round_margin, radius_);
  }
  return p;
}

double Room::volume_inside() const {
  double volume = 1;
  if (!cell_.upright()) {
    volume = cell_volume(cell_, dimension_);
    for (int a = 0; a < dimension_; ++a) volume *= 1 - 2 * margin[a] / width(a);
    return volume;
  }
  for (int a = 0; a < dimension_; ++a)
    if (!across(a)) volume *= width(a) - 2 * margin[a];
  const double r = radius_ - round_margin;
  return round() ? volume * std::numbers::pi * r * r : volume;
}

std::vector<Vec3> Room::wrapped(std::vector<Vec3> points) const {
  for (Vec3& x : points) x = faces_.wrapped(x);
  return points;
}

std::vector<Vec3> Room::with_copies(std::vector<Vec3> points, double range) const {
  for (int a = 0; a < dimension_; ++a) {
    if (!periodic(a)) continue;
    const std::size_t own = points.size();
    const Vec3 edge = cell_.edge(a);
    const double least = -range * (1 + 1e-9);  // one too many does no harm
    for (std::size_t k = 0; k < own; ++k)
      for (const Vec3& copy : {points[k] - edge, points[k] + edge})
        if (above_low(a, copy) > least && below_high(a, copy) > least) points.push_back(copy);
  }
  return points;
}

double shell_volume(int dimension, double inner, double outer) {
  constexpr double pi = std::numbers::pi;
  if (dimension == 2) return pi * (outer * outer - inner * inner);
  return 4 * pi / 3 * (outer * outer * outer - inner * inner * inner);
}

}  // namespace jam
