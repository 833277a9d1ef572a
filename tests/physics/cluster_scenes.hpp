// Scenes of clusters, shared by the physics tests.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "jamscape/base/random.hpp"
#include "jamscape/dem/cluster_engine.hpp"
#include "jamscape/geometry/cluster_shape.hpp"

namespace jam::scenes {

/// The law of S3 with k_n = 1, damping ratio eta and tangential stiffness 1/2.
inline PairLaw<> s3_law(double eta, double mu, bool clipped = true) {
  PairLaw<> law{};
  law.k_n = 1;
  law.gamma_n = 2 * eta;
  law.k_t = 0.5;
  law.gamma_t = 2 * eta * std::sqrt(0.5);
  law.inverse_k_t = 2;
  law.mu = mu;
  law.lever_cut = 0.5;
  law.floor = clipped ? 0 : -std::numeric_limits<double>::infinity();
  return law;
}

/// Two bodies of mass 1 of this shape; the second comes along -x.
inline ClusterSetup two_bodies(const ClusterShape& shape, double speed, double dt) {
  ClusterSetup s;
  s.shapes = {shape};
  s.density = 1 / shape.volume;
  s.bodies.shape = {0, 0};
  s.bodies.position = {Vec3{}, Vec3{2 * shape.circumradius + 0.01, 0, 0}};
  s.bodies.velocity = {Vec3{speed / 2, 0, 0}, Vec3{-speed / 2, 0, 0}};
  s.bodies.spin = {Vec3{}, Vec3{}};
  s.bodies.orientation = {Quaternion{}, Quaternion{}};
  s.grain_law = s.wall_law = s3_law(0, 0);
  s.dt = dt;
  return s;
}

inline Quaternion turn_about(const Vec3& axis, double angle) {
  const double s = std::sin(angle / 2) / norm(axis);
  return {std::cos(angle / 2), s * axis[0], s * axis[1], s * axis[2]};
}

inline Quaternion random_turn(Random& random) {
  for (;;) {
    const Quaternion q{2 * random.uniform() - 1, 2 * random.uniform() - 1, 2 * random.uniform() - 1,
                       2 * random.uniform() - 1};
    const double n2 = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    if (n2 > 0.01 && n2 < 1) return normalized(q);
  }
}

inline Packing now(ClusterEngine& engine) {
  engine.compute_forces();
  Packing p = engine.record();
  engine.advance();
  return p;
}

inline Vec3 momentum(const Packing& p) {
  Vec3 sum{};
  for (std::size_t k = 0; k < p.grains.size(); ++k) sum += p.grains.mass[k] * p.grains.velocity[k];
  return sum;
}

/// About the origin.
inline Vec3 angular_momentum(const Packing& p, double density) {
  Vec3 sum{};
  for (std::size_t k = 0; k < p.grains.size(); ++k) {
    const Grains& g = p.grains;
    const ClusterShape& shape = p.shapes[static_cast<std::size_t>(g.shape[k])];
    const double s = g.scale[k], unit = density * s * s * s * s * s;
    const Vec3 w = rotate(conjugate(g.orientation[k]), g.spin[k]);
    const Vec3 own{unit * shape.inertia[0] * w[0], unit * shape.inertia[1] * w[1], unit * shape.inertia[2] * w[2]};
    sum += g.mass[k] * cross(g.position[k], g.velocity[k]) + rotate(g.orientation[k], own);
  }
  return sum;
}

/// Runs until the bodies have touched and are apart for a while; the record then. A pair of clusters may part and
/// touch again.
inline Packing after_contact(ClusterEngine& engine, std::int64_t most_steps = 400000) {
  bool touched = false;
  int apart = 0;
  Packing p;
  for (std::int64_t k = 0; k < most_steps && apart < 200; ++k) {
    p = now(engine);
    const bool touching = p.contacts.size() > 0;
    touched = touched || touching;
    apart = touched && !touching ? apart + 1 : 0;
  }
  return p;
}

}  // namespace jam::scenes
