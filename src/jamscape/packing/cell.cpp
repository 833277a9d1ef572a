#include "jamscape/packing/cell.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace jam {
namespace {

using Edges = std::array<Vec3, 3>;

constexpr double rounding = 1e-12;  // of the longest edge: what is shorter is none

struct Basis {
  Vec3 origin;
  Edges edge;
  std::array<bool, 3> periodic;
  std::size_t count;  // edges that count: two in the plane

  bool repeats(std::size_t k) const { return periodic[k]; }
};

double longest(const Basis& b) {
  double most = 0;
  for (std::size_t k = 0; k < b.count; ++k) most = std::max(most, norm(b.edge[k]));
  return most;
}

/// One step to shorter periodic edges; false where there is none.
bool shorten(Basis& b) {
  bool found = false;
  for (std::size_t k = 0; k < b.count; ++k) {
    if (!b.repeats(k)) continue;
    for (std::size_t l = 0; l < b.count; ++l) {
      if (l == k || !b.repeats(l) || norm(b.edge[l]) == 0) continue;
      const Vec3 shorter = b.edge[k] - std::round(dot(b.edge[k], b.edge[l]) / dot(b.edge[l], b.edge[l])) * b.edge[l];
      if (norm(shorter) < (1 - rounding) * norm(b.edge[k])) b.edge[k] = shorter, found = true;
    }
    if (b.count < 3 || !b.repeats((k + 1) % 3) || !b.repeats((k + 2) % 3)) continue;
    for (const double s : {-1.0, 1.0})
      for (const double t : {-1.0, 1.0}) {
        const Vec3 shorter = b.edge[k] + s * b.edge[(k + 1) % 3] + t * b.edge[(k + 2) % 3];
        if (norm(shorter) < (1 - rounding) * norm(b.edge[k])) b.edge[k] = shorter, found = true;
      }
  }
  return found;
}

/// Edges that do not repeat, without their parts along those that do: what lies beyond a periodic face comes back
/// through the other.
void straighten(Basis& b) {
  Edges across;  // an orthonormal basis of the periodic ones
  std::size_t count = 0;
  for (std::size_t k = 0; k < b.count; ++k) {
    if (!b.repeats(k)) continue;
    Vec3 rest = b.edge[k];
    for (std::size_t l = 0; l < count; ++l) rest -= dot(rest, across[l]) * across[l];
    if (norm(rest) > 0) across[count++] = (1 / norm(rest)) * rest;
  }
  for (std::size_t k = 0; k < b.count; ++k)
    for (std::size_t l = 0; !b.repeats(k) && l < count; ++l) b.edge[k] -= dot(b.edge[k], across[l]) * across[l];
}

/// Edge k is the one that goes farthest along axis k, upwards.
void sort_by_axis(Basis& b) {
  for (std::size_t k = 0; k < b.count; ++k) {
    const int axis = static_cast<int>(k);
    std::size_t best = k;
    for (std::size_t l = k + 1; l < b.count; ++l)
      if (std::abs(b.edge[l][axis]) > (1 + rounding) * std::abs(b.edge[best][axis])) best = l;
    std::swap(b.edge[k], b.edge[best]);
    std::swap(b.periodic[k], b.periodic[best]);
    if (b.edge[k][axis] >= 0) continue;
    if (!b.periodic[k]) b.origin += b.edge[k];
    b.edge[k] = -1.0 * b.edge[k];
  }
}

}  // namespace

Domain make_cell(const Vec3& origin, const std::array<Vec3, 3>& edges, const std::array<bool, 3>& periodic) {
  Domain cell;
  cell.lo = origin;
  cell.periodic = periodic;
  for (int k = 0; k < 3; ++k) {
    const auto e = static_cast<std::size_t>(k);
    cell.hi[k] = origin[k] + edges[e][k];
    cell.tilt[e] = edges[e];
    cell.tilt[e][k] = 0;
  }
  return cell;
}

double cell_volume(const Domain& cell, int dimension) {
  const Vec3 side = cell.hi - cell.lo;
  if (cell.upright()) return side[0] * side[1] * (dimension == 3 ? side[2] : 1.0);
  const Vec3 ab = cross(cell.edge(0), cell.edge(1));
  return std::abs(dimension == 3 ? dot(ab, cell.edge(2)) : ab[2]);
}

Domain reduced(const Domain& cell, int dimension) {
  if (cell.upright()) return cell;
  Basis b{cell.lo, {cell.edge(0), cell.edge(1), cell.edge(2)}, cell.periodic, static_cast<std::size_t>(dimension)};
  for (int step = 0; step < 1000 && shorten(b); ++step) {
  }
  straighten(b);
  sort_by_axis(b);
  const double none = rounding * longest(b);
  for (std::size_t k = 0; k < b.count; ++k)
    for (int a = 0; a < 3; ++a)
      if (a != static_cast<int>(k) && std::abs(b.edge[k][a]) <= none) b.edge[k][a] = 0;
  return make_cell(b.origin, b.edge, b.periodic);
}

Faces::Faces(const Domain& cell, int dimension) : cell_(cell), dimension_(dimension), upright_(cell.upright()) {
  for (int k = 0; k < dimension; ++k) {
    const auto e = static_cast<std::size_t>(k);
    if (upright_) {
      width_[e] = cell.hi[k] - cell.lo[k];
      continue;
    }
    const Vec3 b = cell.edge((k + 1) % 3), c = dimension == 3 ? cell.edge((k + 2) % 3) : Vec3{0, 0, 1};
    Vec3 n = dimension == 2 ? cross(cell.edge(1 - k), c) : cross(b, c);
    if (dot(n, cell.edge(k)) < 0) n = -1.0 * n;
    if (const double length = norm(n); length > 0) n = (1 / length) * n;
    normal_[e] = n;
    width_[e] = dot(n, cell.edge(k));
  }
}

double Faces::above_low(int k, const Vec3& x) const {
  return upright_ ? x[k] - cell_.lo[k] : dot(normal_[static_cast<std::size_t>(k)], x - cell_.lo);
}

double Faces::below_high(int k, const Vec3& x) const {
  return upright_ ? cell_.hi[k] - x[k] : width(k) - above_low(k, x);
}

Vec3 Faces::wrapped(Vec3 x) const {
  for (int k = 0; k < dimension_; ++k) {
    if (!cell_.periodic[static_cast<std::size_t>(k)]) continue;
    if (upright_)
      x[k] -= width(k) * std::floor((x[k] - cell_.lo[k]) / width(k));
    else
      x -= std::floor(above_low(k, x) / width(k)) * cell_.edge(k);
  }
  return x;
}

}  // namespace jam
