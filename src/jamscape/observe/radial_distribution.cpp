#include "jamscape/observe/radial_distribution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "jamscape/base/border.hpp"
#include "jamscape/observe/bodies.hpp"
#include "jamscape/observe/box.hpp"
#include "jamscape/observe/point_grid.hpp"
#include "jamscape/observe/room.hpp"
#include "jamscape/stats/curves.hpp"

namespace jam {
namespace {

// A margin that leaves enough between the walls.
double fitting(double margin, double width) {
  return exceeds(2 * margin, 0.75 * width) ? std::min(margin, width / 6) : margin;
}

// Part of a ball of radius r about a point that lies between it and a plane at distance a, a half space away or more.
double half_ball(double r, double a) {
  constexpr double pi = std::numbers::pi;
  return r < a ? 2 * pi / 3 * r * r * r : 2 * pi * (a * a * a / 3 + a * (r * r - a * a) / 2);
}

// The room with its margins in the packing's units, and what the references of this packing have in common.
struct Surroundings {
  Room room;
  int ends;
  double range;

  Surroundings(const Packing& p, const MeasureOptions& o, double length)
      : room(p, wall_distance(p)), ends(height_axis(p)), range(o.rdf_range * length) {
    for (int a = 0; a < p.dimension; ++a) {
      if (!room.walled(a)) continue;
      const bool thin = p.dimension == 3 && a != ends && !reaches(room.width(a), 2 * range);
      if (thin && (room.thin < 0 || room.width(a) < room.width(room.thin))) room.thin = a;
      room.margin[a] = fitting((a == ends ? o.rdf_margin_ends : o.rdf_margin_sides) * length, room.width(a));
    }
    if (room.thin >= 0) room.margin[room.thin] = 0;
    if (room.round()) room.round_margin = fitting(o.rdf_margin_cylinder * length, room.diameter());
  }

  double sides_margin(int dimension) const {
    double least = room.round() ? room.round_margin : std::numeric_limits<double>::infinity();
    for (int a = 0; a < dimension; ++a)
      if (a != ends && room.walled(a)) least = std::min(least, room.margin[a]);
    return std::isfinite(least) ? least : 0;
  }
};

}  // namespace

std::vector<double> RadialDistribution::sum(const std::vector<std::vector<double>>& counts) const {
  if (counts.empty()) return std::vector<double>(distance.size(), 0.0);
  std::vector<std::size_t> all(counts.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return sum_of_curves(counts, all);
}

RadialDistribution radial_distribution(const Packing& p, const MeasureOptions& options) {
  const auto bins = static_cast<std::size_t>(std::max(1.0, std::round(options.rdf_range / options.rdf_bin)));
  RadialDistribution result;
  for (std::size_t b = 0; b < bins; ++b) result.distance.push_back((static_cast<double>(b) + 0.5) * options.rdf_bin);
  if (p.grains.size() == 0) return result;

  const double length = result.length = body_length(p), width = options.rdf_bin * length;
  const Surroundings around(p, options, length);
  const Room& room = around.room;
  result.margin_ends = room.margin[around.ends] / length;
  result.margin_sides = around.sides_margin(p.dimension) / length;
  const double density = static_cast<double>(p.grains.size()) / box_volume(p);
  const double range = static_cast<double>(bins) * width, per_width = 1 / width;
  std::vector<double> whole_shell(bins);
  for (std::size_t b = 0; b < bins; ++b)
    whole_shell[b] =
        density * shell_volume(p.dimension, static_cast<double>(b) * width, static_cast<double>(b + 1) * width);

  const std::vector<Vec3> position = room.wrapped(p.grains.position);
  const PointGrid grid(room.with_copies(position, range), std::max(length, range / 6));
  for (const Vec3& x : position) {
    const Room::Place place = room.place(x);
    const double reach = std::min(borders_reached(place.reach * per_width), static_cast<double>(bins));
    if (!place.inside || !(reach >= 1)) continue;
    const auto last = static_cast<std::size_t>(reach) - 1;
    std::vector<double>& pairs = result.pairs.emplace_back(bins, 0.0);
    grid.each_within(x, on_from(reach * width), [&](double r2) {
      ++pairs[std::min(static_cast<std::size_t>(borders_reached(std::sqrt(r2) * per_width)), last)];
    });
    --pairs[0];  // itself
    std::vector<double>& ideal = result.ideal.emplace_back(bins, 0.0);
    std::copy_n(whole_shell.begin(), last + 1, ideal.begin());
    if (room.thin < 0) continue;
    const double below = room.above_low(room.thin, x), above = room.below_high(room.thin, x);
    const auto ball = [&](double r) { return half_ball(r, std::max(below, 0.0)) + half_ball(r, std::max(above, 0.0)); };
    for (std::size_t b = 0; b <= last; ++b)
      ideal[b] = density * (ball(static_cast<double>(b + 1) * width) - ball(static_cast<double>(b) * width));
  }
  return result;
}

}  // namespace jam
