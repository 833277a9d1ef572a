#include "jamscape/observe/room.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "jamscape/base/border.hpp"
#include "jamscape/observe/box.hpp"

namespace jam {

Room::Room(const Packing& packing, double layer)
    : dimension_(packing.dimension),
      lo_(packing.domain.lo),
      hi_(packing.domain.hi),
      periodic_(packing.domain.periodic) {
  double bead = 0;
  for (const Wall& w : packing.walls) bead = std::max(bead, w.bead_radius);
  layer_ = layer + bead;
  if (const Wall* cylinder = find_cylinder(packing)) {
    axis_ = wall_axis(*cylinder, dimension_);
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
    if (periodic_[static_cast<std::size_t>(a)])
      p.reach = std::min(p.reach, width(a) / 2);
    else if (walled(a) && a != thin)
      keep_from(std::min(x[a] - lo_[a], hi_[a] - x[a]), margin[a], width(a));
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
  for (int a = 0; a < dimension_; ++a)
    if (!across(a)) volume *= width(a) - 2 * margin[a];
  const double r = radius_ - round_margin;
  return round() ? volume * std::numbers::pi * r * r : volume;
}

std::vector<Vec3> Room::wrapped(std::vector<Vec3> points) const {
  for (int a = 0; a < dimension_; ++a) {
    if (!periodic_[static_cast<std::size_t>(a)]) continue;
    for (Vec3& x : points) x[a] -= width(a) * std::floor((x[a] - lo_[a]) / width(a));
  }
  return points;
}

std::vector<Vec3> Room::with_copies(std::vector<Vec3> points, double range) const {
  for (int a = 0; a < dimension_; ++a) {
    if (!periodic_[static_cast<std::size_t>(a)]) continue;
    const std::size_t own = points.size();
    for (std::size_t k = 0; k < own; ++k)
      for (const double shift : {-width(a), width(a)}) {
        Vec3 copy = points[k];
        copy[a] += shift;
        if (copy[a] > lo_[a] - range && copy[a] < hi_[a] + range) points.push_back(copy);
      }
  }
  return points;
}

double shell_volume(int dimension, double inner, double outer) {
  constexpr double pi = std::numbers::pi;
  if (dimension == 2) return pi * (outer * outer - inner * inner);
  return 4 * pi / 3 * (outer * outer * outer - inner * inner * inner);
}

}  // namespace jam
