#include <fmt/format.h>

#include <cmath>

#include "jamscape/base/error.hpp"
#include "jamscape/geometry/arm_union.hpp"
#include "jamscape/geometry/arrange.hpp"
#include "jamscape/geometry/cluster_shape.hpp"
#include "jamscape/geometry/segments.hpp"

namespace jam {
namespace {

bool finite(const Vec3& v) { return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]); }

void check_arm(const Arm& arm, std::size_t number, int dimension) {
  const std::string place = fmt::format("arm {}", number);
  if (!finite(arm.centre)) throw usage_error("the centre is not a number", place);
  if (!(arm.radius > 0) || !std::isfinite(arm.radius))
    throw usage_error(fmt::format("radius {} is not positive", arm.radius), place, "0.5, for a diameter of 1");
  if (!(arm.half_length >= 0) || !std::isfinite(arm.half_length))
    throw usage_error(fmt::format("half length {} is negative: the arm is shorter than it is thick", arm.half_length),
                      place, "a half length of (L - d) / 2 with L >= d; 0 is a sphere");
  if (!finite(arm.direction) || !(norm(arm.direction) > 0))
    throw usage_error("the direction has no length", place, "e.g. the direction 1 0 0");
  const double above = std::abs(arm.centre[2]) / arm.radius;
  const double tilt = arm.half_length > 0 ? std::abs(arm.direction[2]) / norm(arm.direction) : 0;
  if (dimension == 2 && (above > 1e-9 || tilt > 1e-9))
    throw usage_error("the arm leaves the plane z = 0 of a study in two dimensions", place,
                      "a centre and a direction with z = 0, or dimension = 3");
}

void check_connected(const std::vector<Arm>& arms) {
  std::vector<bool> reached(arms.size(), false);
  std::vector<std::size_t> next = {0};
  reached[0] = true;
  while (!next.empty()) {
    const std::size_t a = next.back();
    next.pop_back();
    for (std::size_t b = 0; b < arms.size(); ++b) {
      if (reached[b] || axis_distance(arms[a], arms[b]) >= (1 - 1e-9) * (arms[a].radius + arms[b].radius)) continue;
      reached[b] = true;
      next.push_back(b);
    }
  }
  for (std::size_t b = 0; b < arms.size(); ++b)
    if (!reached[b])
      throw usage_error(fmt::format("arm {} does not overlap the body of arm 1: the arms are not one body", b + 1), {},
                        "arms that overlap, or a shape of its own for each piece");
}

struct Axes {
  double moments[3];  ///< second moments along the axes
  Vec3 axis[3];
};

/// Jacobi's rotations, each by less than 45 degrees: axes stay next to those they start from, and a tensor that is
/// diagonal to the accuracy of the integrals is left alone.
Axes principal_axes(double (&m)[3][3], int dimension) {
  Axes axes{{}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const double negligible = 1e-9 * (m[0][0] + m[1][1] + m[2][2]);
  for (int sweep = 0; sweep < 30; ++sweep) {
    bool turned = false;
    for (const auto& [p, q] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
      if ((dimension == 2 && q == 2) || std::abs(m[p][q]) <= negligible) continue;
      turned = true;
      const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
      const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::hypot(theta, 1.0));
      const double c = 1 / std::hypot(t, 1.0), s = t * c;
      for (int k = 0; k < 3; ++k) {
        const double kp = m[k][p], kq = m[k][q];
        m[k][p] = c * kp - s * kq;
        m[k][q] = s * kp + c * kq;
      }
      for (int k = 0; k < 3; ++k) {
        const double pk = m[p][k], qk = m[q][k];
        m[p][k] = c * pk - s * qk;
        m[q][k] = s * pk + c * qk;
      }
      const Vec3 old = axes.axis[p];
      axes.axis[p] = c * old - s * axes.axis[q];
      axes.axis[q] = s * old + c * axes.axis[q];
    }
    if (!turned) break;
  }
  for (int k = 0; k < 3; ++k) axes.moments[k] = m[k][k];
  return axes;
}

Vec3 in_axes(const Axes& axes, const Vec3& v) {
  return {dot(axes.axis[0], v), dot(axes.axis[1], v), dot(axes.axis[2], v)};
}

}  // namespace

ClusterShape custom_shape(std::vector<Arm> arms, int dimension) {
  if (arms.empty()) throw usage_error("a shape needs at least one arm");
  for (std::size_t a = 0; a < arms.size(); ++a) check_arm(arms[a], a + 1, dimension);
  for (Arm& arm : arms) arm.direction = (1 / norm(arm.direction)) * arm.direction;
  check_connected(arms);

  const UnionIntegrals sum = integrate_union(arms);
  const Vec3 centre = (1 / sum.volume) * sum.first;
  double about_centre[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) about_centre[i][j] = sum.second[i][j] - sum.volume * centre[i] * centre[j];
  const Axes axes = principal_axes(about_centre, dimension);
  for (Arm& arm : arms) {
    arm.centre = in_axes(axes, arm.centre - centre);
    arm.direction = in_axes(axes, arm.direction);
    if (dimension == 2) arm.centre[2] = 0;
    if (dimension == 2 && arm.half_length > 0) arm.direction[2] = 0;
  }
  ClusterShape shape = arranged("custom", std::move(arms));
  shape.volume = sum.volume;
  shape.surface = sum.surface;
  shape.area = shadow_area(shape.arms);
  const auto& m = axes.moments;
  shape.inertia = {m[1] + m[2], m[2] + m[0], m[0] + m[1]};
  return shape;
}

}  // namespace jam
