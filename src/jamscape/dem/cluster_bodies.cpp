#include "jamscape/dem/cluster_bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "jamscape/base/error.hpp"
#include "jamscape/dem/cluster_motion.hpp"

namespace jam {
namespace {

using R = ClusterRow;

/// Moments of inertia closer together than this part count as one: those of a star come out of a quadrature.
constexpr double same_moment = 1e-6;
/// A direction or a place this far out of the plane is a mistake, not a rounding error.
constexpr double in_plane = 1e-9;

void check_body(const ClusterBodies& b, std::size_t k, const std::vector<ClusterShape>& shapes, bool planar) {
  const std::string name = "body " + std::to_string(k);
  if (b.shape[k] < 0 || static_cast<std::size_t>(b.shape[k]) >= shapes.size())
    throw usage_error(name + " has shape " + std::to_string(b.shape[k]) + " of " + std::to_string(shapes.size()), {},
                      "shapes are counted from 0");
  if (!b.scale.empty() && !(b.scale[k] > 0)) throw usage_error(name + " has a size factor that is not above 0");
  if (!planar) return;
  bool flat = std::abs(b.position[k][2]) <= in_plane;
  for (const Arm& arm : shapes[static_cast<std::size_t>(b.shape[k])].arms)
    flat =
        flat && std::abs(arm.centre[2]) <= in_plane && (arm.half_length == 0 || std::abs(arm.direction[2]) <= in_plane);
  if (!b.orientation.empty())
    flat = flat && std::abs(b.orientation[k].x) <= in_plane && std::abs(b.orientation[k].y) <= in_plane;
  if (!flat)
    throw usage_error(name + " reaches out of the plane z = 0", {},
                      "in two dimensions arms lie in the plane and bodies turn about z only");
}

}  // namespace

void append_bodies(ClusterState& s, const ClusterBodies& bodies, const std::vector<ClusterShape>& shapes,
                   double density, bool planar) {
  const std::size_t n = bodies.size();
  for (const std::size_t size :
       {bodies.scale.size(), bodies.velocity.size(), bodies.spin.size(), bodies.orientation.size()})
    if (size != 0 && size != n) throw usage_error("arrays of bodies have different lengths");
  if (bodies.position.size() != n) throw usage_error("arrays of bodies have different lengths");
  const auto given = [](const auto& values, std::size_t k, auto otherwise) {
    return values.empty() ? otherwise : values[k];
  };
  for (std::size_t k = 0; k < n; ++k) {
    check_body(bodies, k, shapes, planar);
    const ClusterShape& shape = shapes[static_cast<std::size_t>(bodies.shape[k])];
    const double scale = given(bodies.scale, k, 1.0), scale3 = scale * scale * scale;
    const double mass = density * shape.volume * scale3;
    Vec3 x = bodies.position[k], v = given(bodies.velocity, k, Vec3{}), w = given(bodies.spin, k, Vec3{});
    Quaternion q = normalized(given(bodies.orientation, k, Quaternion{}));
    Vec3 moment = (density * scale3 * scale * scale) * shape.inertia;
    const double mean = (moment[0] + moment[1] + moment[2]) / 3;
    bool top = false;
    for (int c = 0; c < 3; ++c) top = top || std::abs(moment[c] - mean) > same_moment * mean;
    if (planar) {
      x[2] = v[2] = w[0] = w[1] = 0;
      q = normalized({q.w, 0, 0, q.z});
    } else if (!top) {
      moment = {mean, mean, mean};
    }
    double reach = 0;
    for (const Arm& arm : shape.arms)
      for (const double end : {-1.0, 1.0})
        reach = std::max(reach, norm(arm.centre + (end * arm.half_length) * arm.direction));
    const std::array<double, R::stride> row{x[0], x[1], x[2], mass,          v[0], v[1], v[2], 0,
                                            w[0], w[1], w[2], scale * reach, q.w,  q.x,  q.y,  q.z};
    const Vec3 own = rotate(conjugate(q), w);
    const Vec3 l = top && !planar ? rotate(q, {moment[0] * own[0], moment[1] * own[1], moment[2] * own[2]})
                                  : Vec3{moment[0] * w[0], moment[1] * w[1], moment[2] * w[2]};
    const std::array<double, R::force_stride> inverse{
        1 / mass,      1 / mass, planar ? 0 : 1 / mass, 0, planar ? 0 : 1 / moment[0], planar ? 0 : 1 / moment[1],
        1 / moment[2], 0};
    s.rows.insert(s.rows.end(), row.begin(), row.end());
    s.momentum.insert(s.momentum.end(), {l[0], l[1], l[2], 0});
    s.inverse.insert(s.inverse.end(), inverse.begin(), inverse.end());
    s.top.push_back(top && !planar);
    s.id.push_back(static_cast<std::uint32_t>(s.id.size()));
    s.shape.push_back(bodies.shape[k]);
    s.scale.push_back(scale);
    s.radius.push_back(scale * shape.circumradius);
  }
  rebuild_arms(s, shapes);
}

void rebuild_arms(ClusterState& s, const std::vector<ClusterShape>& shapes) {
  s.own_arms.clear();
  s.centred = true;
  std::vector<std::uint32_t> own_of_shape;
  for (const ClusterShape& shape : shapes) {
    own_of_shape.push_back(static_cast<std::uint32_t>(s.own_arms.size()));
    for (const Arm& arm : shape.arms) {
      const Vec3 &c = arm.centre, &u = arm.direction;
      s.own_arms.insert(s.own_arms.end(), {c[0], c[1], c[2], arm.radius, u[0], u[1], u[2], arm.half_length});
      s.centred = s.centred && c == Vec3{};
    }
  }
  const std::size_t n = s.count();
  const auto shape_of = [&](std::size_t k) { return static_cast<std::size_t>(s.shape[k]); };
  const auto arms_of = [&](std::size_t k) { return static_cast<std::uint32_t>(shapes[shape_of(k)].arms.size()); };
  std::vector<std::uint32_t> first_by_id(n + 1, 0);
  for (std::size_t k = 0; k < n; ++k) first_by_id[s.id[k] + 1] = arms_of(k);
  std::partial_sum(first_by_id.begin(), first_by_id.end(), first_by_id.begin());
  s.first_arm.assign(1, 0);
  s.first_own.clear(), s.arm_id.clear(), s.arm_body.clear();
  for (std::size_t k = 0; k < n; ++k) {
    for (std::uint32_t a = 0; a < arms_of(k); ++a) {
      s.arm_id.push_back(first_by_id[s.id[k]] + a);
      s.arm_body.push_back(static_cast<std::uint32_t>(k));
    }
    s.first_own.push_back(own_of_shape[shape_of(k)]);
    s.first_arm.push_back(static_cast<std::uint32_t>(s.arm_id.size()));
  }
  s.forces.assign(n * R::force_stride, 0.0);
  s.moved.resize(n), s.skin.resize(n);
  s.arms.assign(s.arm_count() * R::arm_stride, 0.0);
  for (const double far : {-1e15, 1e15}) s.arms.insert(s.arms.end(), {far, far, far, 0.0, 1.0, 0.0, 0.0, 0.0});
  refresh(s);
}

void refresh(ClusterState& s) {
  MotionArrays motion = motion_arrays(s, 0, {});
  for (std::size_t k = 0; k < s.count(); ++k) {
    double* row = s.row(k);
    const Vec3 w = spin_of(s, k, vec3(s.momentum.data() + 4 * k));
    for (std::size_t c = 0; c < 3; ++c) row[R::spin + c] = w[static_cast<int>(c)];
    place_arms(motion, k, rows_of(frame_of(turn_at(row + R::orientation))));
  }
}

Vec3 spin_of(const ClusterState& s, std::size_t body, const Vec3& l) {
  const double* inverse = s.inverse.data() + body * R::force_stride + 4;
  if (!s.top[body]) return {l[0] * inverse[0], l[1] * inverse[1], l[2] * inverse[2]};
  return top_spin(frame_of(turn_at(s.row(body) + R::orientation)), l.c, inverse);
}

std::vector<std::uint32_t> spatial_order(const ClusterState& s) {
  Vec3 lo{1e300, 1e300, 1e300};
  double widest = 1e-300;
  for (std::size_t k = 0; k < s.count(); ++k) {
    widest = std::max(widest, s.radius[k]);
    for (int c = 0; c < 3; ++c) lo[c] = std::min(lo[c], s.row(k)[c]);
  }
  constexpr int bits = 20;
  std::vector<std::uint64_t> key(s.count(), 0);
  for (std::size_t k = 0; k < s.count(); ++k)
    for (int c = 0; c < 3; ++c) {
      const double cell = std::min((s.row(k)[c] - lo[c]) / widest, std::ldexp(1.0, bits) - 1);
      const auto at = static_cast<std::uint64_t>(cell > 0 ? cell : 0);
      for (int bit = 0; bit < bits; ++bit) key[k] |= (at >> bit & 1) << (3 * bit + c);
    }
  std::vector<std::uint32_t> order(s.count());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key[a] < key[b]; });
  return order;
}

void reorder(ClusterState& s, const std::vector<std::uint32_t>& order, const std::vector<ClusterShape>& shapes) {
  const auto permute = [&](auto& values, std::size_t stride) {
    const auto old = values;
    for (std::size_t k = 0; k < order.size(); ++k)
      std::copy_n(old.begin() + static_cast<std::ptrdiff_t>(order[k] * stride), stride,
                  values.begin() + static_cast<std::ptrdiff_t>(k * stride));
  };
  permute(s.rows, R::stride), permute(s.momentum, 4), permute(s.inverse, R::force_stride), permute(s.top, 1);
  permute(s.moved, 1), permute(s.skin, 1), permute(s.id, 1), permute(s.shape, 1), permute(s.scale, 1),
      permute(s.radius, 1);
  rebuild_arms(s, shapes);
}

}  // namespace jam
