#include "jamscape/geometry/arm_union.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "jamscape/geometry/exposed.hpp"

namespace jam {
namespace {

using std::numbers::pi;

/// surface; volume; first moments; second moments xx, yy, zz, yz, zx, xy.
using Sums = std::array<double, 11>;

Sums operator+(Sums a, const Sums& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] += b[k];
  return a;
}
double distance(const Sums& a, const Sums& b) {
  double d = 0;
  for (std::size_t k = 0; k < a.size(); ++k) d = std::max(d, std::abs(a[k] - b[k]));
  return d;
}

/// Gauss-Lobatto, eight points, the ends among them: a kink just beyond a panel's end is seen. Calls f(x, weight).
template <class F>
void eight_points(double lo, double hi, F&& f) {
  constexpr double x[4] = {0.2092992179024789, 0.5917001814331423, 0.8717401485096066, 1};
  constexpr double w[4] = {0.4124587946587039, 0.3411226924835044, 0.2107042271435061, 1.0 / 28};
  const double mid = (lo + hi) / 2, half = (hi - lo) / 2;
  for (int k = 0; k < 4; ++k) {
    f(mid - half * x[k], half * w[k]);
    f(mid + half * x[k], half * w[k]);
  }
}

/// A patch of boundary at x with normal n and area `a`, added to the sums.
void add_patch(Sums& sums, const Vec3& x, const Vec3& n, double a) {
  const double flux = dot(x, n) * a;
  sums[0] += a;
  sums[1] += flux / 3;
  for (int i = 0; i < 3; ++i) {
    sums[std::size_t(2 + i)] += x[i] * flux / 4;
    sums[std::size_t(5 + i)] += x[i] * x[i] * flux / 5;
    sums[std::size_t(8 + i)] += x[(i + 1) % 3] * x[(i + 2) % 3] * flux / 5;
  }
}

/// The other arms as `own` sees them: those before it own what coincides, so they are a trifle larger, those after it
/// a trifle smaller.
std::vector<Arm> covers_of(const std::vector<Arm>& arms, std::size_t own) {
  constexpr double trifle = 1e-11;
  std::vector<Arm> covers;
  for (std::size_t b = 0; b < arms.size(); ++b) {
    if (b == own) continue;
    covers.push_back(arms[b]);
    covers.back().radius *= b < own ? 1 + trifle : 1 - trifle;
  }
  return covers;
}

/// Two unit vectors that complete u; for a u along an axis they are axes too, so that a star is cut symmetrically.
std::array<Vec3, 2> complete(const Vec3& u) {
  int least = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(u[k]) < std::abs(u[least])) least = k;
  Vec3 a{};
  a[least] = 1;
  a = a - dot(a, u) * u;
  a = (1 / norm(a)) * a;
  return {a, cross(u, a)};
}

/// What the half plane from the axis of `arm` towards n cuts out of its exposed boundary, per angle.
Sums slice(const Arm& arm, const std::vector<Arm>& covers, const Vec3& n) {
  Sums sums{};
  const double r = arm.radius, h = arm.half_length;
  if (h > 0) {
    const Vec3 foot = arm.centre + r * n;
    for (const Interval& part : exposed_line(covers, foot, arm.direction, {-h, h}))
      eight_points(part.lo, part.hi, [&](double s, double w) { add_patch(sums, foot + s * arm.direction, n, w * r); });
  }
  for (const double side : {-1.0, 1.0}) {
    const Vec3 e = side * arm.direction, centre = arm.centre + h * e;
    for (const Interval& part : exposed_arc(covers, centre, r, e, n)) {
      const auto add = [&](double t, double w) {
        const Vec3 m = std::cos(t) * e + std::sin(t) * n;
        add_patch(sums, centre + r * m, m, w * r * r * std::sin(t));
      };
      const double mid = (part.lo + part.hi) / 2;
      eight_points(part.lo, mid, add);
      eight_points(mid, part.hi, add);
    }
  }
  return sums;
}

/// All of one arm's boundary that is exposed: panels of the angle, halved until the sums stand still.
class Around {
 public:
  Around(const Arm& arm, std::vector<Arm> covers)
      : arm_(arm), covers_(std::move(covers)), across_(complete(arm.direction)) {}

  Sums whole() const {
    constexpr int panels = 8;
    Sums sums{};
    for (int k = 0; k < panels; ++k) {
      const double lo = 2 * pi * k / panels, hi = 2 * pi * (k + 1) / panels;
      sums = sums + halves(lo, hi, panel(lo, hi), 24);
    }
    return sums;
  }

 private:
  Sums panel(double lo, double hi) const {
    Sums sums{};
    eight_points(lo, hi, [&](double angle, double w) {
      Sums part = slice(arm_, covers_, std::cos(angle) * across_[0] + std::sin(angle) * across_[1]);
      for (double& v : part) v *= w;
      sums = sums + part;
    });
    return sums;
  }
  Sums halves(double lo, double hi, const Sums& before, int depth) const {
    constexpr double tolerance = 1e-10;  // of a panel; a few dozen matter
    const double mid = (lo + hi) / 2;
    const Sums left = panel(lo, mid), right = panel(mid, hi);
    if (depth == 0 || distance(left + right, before) <= tolerance * arm_.radius * arm_.radius) return left + right;
    return halves(lo, mid, left, depth - 1) + halves(mid, hi, right, depth - 1);
  }

  const Arm& arm_;
  std::vector<Arm> covers_;
  std::array<Vec3, 2> across_;
};

}  // namespace

UnionIntegrals integrate_union(const std::vector<Arm>& arms) {
  Sums total{};
  for (std::size_t own = 0; own < arms.size(); ++own) total = total + Around(arms[own], covers_of(arms, own)).whole();
  UnionIntegrals out;
  out.surface = total[0];
  out.volume = total[1];
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    out.first[i] = total[std::size_t(2 + i)];
    out.second[i][i] = total[std::size_t(5 + i)];
    out.second[j][k] = out.second[k][j] = total[std::size_t(8 + i)];
  }
  return out;
}

double shadow_area(const std::vector<Arm>& arms) {
  std::vector<Arm> flat = arms;
  for (Arm& arm : flat) {
    const double across = std::hypot(arm.direction[0], arm.direction[1]);
    arm.centre[2] = 0;
    arm.half_length *= across;
    arm.direction = across > 1e-12 ? Vec3{arm.direction[0] / across, arm.direction[1] / across, 0} : Vec3{1, 0, 0};
  }
  double twice = 0;  // int x.n ds over the outline
  for (std::size_t own = 0; own < flat.size(); ++own) {
    const Arm& arm = flat[own];
    const std::vector<Arm> covers = covers_of(flat, own);
    const double r = arm.radius, h = arm.half_length;
    for (const double across : {-1.0, 1.0}) {
      const Vec3 n{-across * arm.direction[1], across * arm.direction[0], 0};
      const Vec3 foot = arm.centre + r * n;
      if (h > 0)
        for (const Interval& part : exposed_line(covers, foot, arm.direction, {-h, h}))
          twice += dot(foot, n) * (part.hi - part.lo);
      for (const double side : {-1.0, 1.0}) {
        const Vec3 e = side * arm.direction, centre = arm.centre + h * e;
        for (const Interval& part : exposed_arc(covers, centre, r, e, n))
          twice += r * (r * (part.hi - part.lo) + dot(centre, e) * (std::sin(part.hi) - std::sin(part.lo)) +
                        dot(centre, n) * (std::cos(part.lo) - std::cos(part.hi)));
      }
    }
  }
  return twice / 2;
}

}  // namespace jam
