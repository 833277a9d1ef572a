#include "jamscape/observe/bodies.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace jam {
namespace {

constexpr double pi = std::numbers::pi;

const ClusterShape& shape(const Packing& p, std::size_t grain) {
  return p.shapes[static_cast<std::size_t>(p.grains.shape[grain])];
}

template <class Value>
double mean_over_bodies(const Packing& p, const Value& value) {
  double sum = 0;
  for (std::size_t i = 0; i < p.grains.size(); ++i) sum += value(i);
  return p.grains.size() > 0 ? sum / static_cast<double>(p.grains.size()) : 0;
}

}  // namespace

double body_volume(const Packing& p, std::size_t grain) {
  if (!p.shapes.empty()) {
    const double s = p.grains.scale[grain];
    return shape(p, grain).volume * s * s * s;
  }
  const double r = p.grains.radius[grain];
  return p.dimension == 2 ? pi * r * r : 4 * pi / 3 * r * r * r;
}

double body_area(const Packing& p, std::size_t grain) {
  if (!p.shapes.empty()) return shape(p, grain).area * p.grains.scale[grain] * p.grains.scale[grain];
  return pi * p.grains.radius[grain] * p.grains.radius[grain];
}

double body_length(const Packing& p) {
  return mean_over_bodies(
      p, [&](std::size_t i) { return p.shapes.empty() ? 2 * p.grains.radius[i] : shape(p, i).length; });
}

double wall_distance(const Packing& p) {
  return mean_over_bodies(p, [&](std::size_t i) {
    if (p.shapes.empty()) return p.grains.radius[i];
    double thinnest = std::numeric_limits<double>::infinity();
    for (const Arm& arm : shape(p, i).arms) thinnest = std::min(thinnest, arm.radius);
    return p.grains.scale[i] * thinnest;
  });
}

}  // namespace jam
