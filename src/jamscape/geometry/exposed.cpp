#include "jamscape/geometry/exposed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace jam {
namespace {

constexpr Interval nothing{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

/// {s : a s^2 + 2 b s + c <= 0}, for a >= 0.
Interval where_negative(double a, double b, double c) {
  constexpr double all = std::numeric_limits<double>::infinity();
  if (a < 1e-15) return c <= 0 ? Interval{-all, all} : nothing;
  const double root = b * b - a * c;
  if (root <= 0) return nothing;
  return {(-b - std::sqrt(root)) / a, (-b + std::sqrt(root)) / a};
}

Interval both(Interval a, Interval b) { return {std::max(a.lo, b.lo), std::min(a.hi, b.hi)}; }

/// The smallest interval around two.
Interval around(Interval a, Interval b) {
  if (a.lo > a.hi) return b;
  if (b.lo > b.hi) return a;
  return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}

/// Where the line x + s u is inside the arm: the hull of what its cylinder and its two end spheres take.
Interval covered_line(const Arm& arm, const Vec3& x, const Vec3& u) {
  const Vec3 w = x - arm.centre;
  const double r2 = arm.radius * arm.radius, along = dot(w, arm.direction), slope = dot(u, arm.direction);
  Interval inside = nothing;
  for (const double end : {-arm.half_length, arm.half_length}) {
    const Vec3 v = w - end * arm.direction;
    inside = around(inside, where_negative(1, dot(v, u), dot(v, v) - r2));
  }
  Interval tube = where_negative(1 - slope * slope, dot(w, u) - along * slope, dot(w, w) - along * along - r2);
  if (std::abs(slope) > 1e-15) {
    const double s = (-arm.half_length - along) / slope, t = (arm.half_length - along) / slope;
    tube = both(tube, {std::min(s, t), std::max(s, t)});
  } else if (std::abs(along) > arm.half_length) {
    tube = nothing;
  }
  return around(inside, tube);
}

/// How far outside an arm the point of an arc at angle t is (squared distances), and how that changes with t.
struct ArcAgainstArm {
  const Arm& arm;
  Vec3 centre, e, f;

  Vec3 point(double t) const { return centre + std::cos(t) * e + std::sin(t) * f; }
  double outside(double t) const { return axis_distance2(arm, point(t)) - arm.radius * arm.radius; }
  double slope(double t) const {
    const Vec3 w = point(t) - arm.centre;
    const double s = std::clamp(dot(w, arm.direction), -arm.half_length, arm.half_length);
    return dot(w - s * arm.direction, std::cos(t) * f - std::sin(t) * e);
  }
};

/// Where g changes sign between a and b, by halving.
template <class G>
double change_of_sign(G&& g, double a, double b) {
  const bool above = g(a) > 0;
  for (int k = 0; k < 52; ++k) {
    const double mid = (a + b) / 2;
    ((g(mid) > 0) == above ? a : b) = mid;
  }
  return (a + b) / 2;
}

/// The parts of 0 <= t <= end that the arm covers. Steps of the angle, and the turning points between them, part the
/// arc into pieces with one change of sign at most.
void cover_arc(std::vector<Interval>& covered, const ArcAgainstArm& arc, double end) {
  constexpr int steps = 16;
  const auto outside = [&](double t) { return arc.outside(t); };
  const auto slope = [&](double t) { return arc.slope(t); };
  double last = 0, last_outside = arc.outside(0), last_slope = arc.slope(0), entered = 0;
  const auto go_to = [&](double t, double here) {
    if ((last_outside > 0) != (here > 0)) {
      const double crossing = change_of_sign(outside, last, t);
      if (here > 0)
        covered.push_back({entered, crossing});
      else
        entered = crossing;
    }
    last = t;
    last_outside = here;
  };
  for (int k = 1; k <= steps; ++k) {
    const double t = end * k / steps, s = arc.slope(t);
    if ((last_slope > 0) != (s > 0)) {
      const double turn = change_of_sign(slope, last, t);
      go_to(turn, arc.outside(turn));
    }
    go_to(t, arc.outside(t));
    last_slope = s;
  }
  if (last_outside <= 0) covered.push_back({entered, end});
}

/// Takes the covered intervals out of the range.
std::vector<Interval> rest(std::vector<Interval> covered, Interval range) {
  std::sort(covered.begin(), covered.end(), [](Interval a, Interval b) { return a.lo < b.lo; });
  std::vector<Interval> left;
  double from = range.lo;
  for (const Interval& c : covered) {
    if (c.lo > c.hi) continue;
    if (c.lo > from) left.push_back({from, std::min(c.lo, range.hi)});
    from = std::max(from, c.hi);
    if (from >= range.hi) return left;
  }
  left.push_back({from, range.hi});
  return left;
}

}  // namespace

double axis_distance2(const Arm& arm, const Vec3& point) {
  const Vec3 w = point - arm.centre;
  const double s = std::clamp(dot(w, arm.direction), -arm.half_length, arm.half_length);
  const Vec3 v = w - s * arm.direction;
  return dot(v, v);
}

std::vector<Interval> exposed_line(std::span<const Arm> covers, const Vec3& x, const Vec3& u, Interval range) {
  std::vector<Interval> covered;
  for (const Arm& arm : covers) covered.push_back(covered_line(arm, x, u));
  return rest(std::move(covered), range);
}

std::vector<Interval> exposed_arc(std::span<const Arm> covers, const Vec3& centre, double radius, const Vec3& e,
                                  const Vec3& f) {
  constexpr double quarter = std::numbers::pi / 2;
  std::vector<Interval> covered;
  for (const Arm& arm : covers) {
    const double reach = radius + arm.radius;
    if (axis_distance2(arm, centre) >= reach * reach) continue;
    cover_arc(covered, {arm, centre, radius * e, radius * f}, quarter);
  }
  return rest(std::move(covered), {0, quarter});
}

}  // namespace jam
