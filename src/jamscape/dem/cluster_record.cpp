// The full record of an instant: every contact by the same law function the kernels use, checked against their sums.
#include <algorithm>
#include <cmath>

#include "jamscape/dem/cluster_contact.hpp"
#include "jamscape/dem/cluster_engine.hpp"
#include "jamscape/dem/cluster_merge.hpp"
#include "jamscape/dem/contact_record.hpp"

namespace jam {
namespace {

using R = ClusterRow;

/// Velocity of a body's point at `lever` from its centre of mass.
Vec3 velocity_at(const double* row, const Vec3& lever) {
  return vec3(row + R::velocity) + cross(vec3(row + R::spin), lever);
}

void describe_walls(Packing& out, const std::vector<ClusterWall>& walls, const std::vector<Vec3>& force) {
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const ClusterWall& from = walls[w];
    Wall wall;
    wall.kind = from.kind;
    wall.force = force[w];
    if (from.kind == WallKind::plane) {
      (from.high ? out.domain.hi : out.domain.lo)[from.axis] = from.position;
      wall.position[from.axis] = from.position;
      wall.normal[from.axis] = from.high ? -1 : 1;
      wall.velocity[from.axis] = from.velocity;
    } else {
      for (int c = 0; c < 3; ++c)
        if (c != from.axis) {
          out.domain.lo[c] = from.centre[c] - from.radius;
          out.domain.hi[c] = from.centre[c] + from.radius;
        }
      wall.position = from.centre;
      wall.normal[from.axis] = 1;
      wall.radius = from.radius;
    }
    out.walls.push_back(wall);
  }
}

}  // namespace

Packing ClusterEngine::record() {
  compute_forces();
  Packing out;
  out.dimension = planar_ ? 2 : 3;
  out.step = step_;
  out.time = time();
  out.shapes = shapes_;
  describe_walls(out, walls_, wall_force_);

  // Bodies by id. Rows hold the velocity half a step ago.
  Grains& g = out.grains;
  const std::size_t n = bodies_.count();
  g.id.resize(n), g.species.resize(n), g.radius.resize(n), g.mass.resize(n);
  g.position.resize(n), g.velocity.resize(n), g.spin.resize(n), g.angle.resize(n);
  g.shape.resize(n), g.scale.resize(n), g.orientation.resize(n);
  double kinetic = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t a = bodies_.id[k];
    const double *row = bodies_.row(k), *inverse = bodies_.inverse.data() + k * R::force_stride;
    const Vec3 force = force_on(k), torque = vec3(bodies_.force(k) + 4);
    g.id[a] = static_cast<std::int64_t>(a);
    g.radius[a] = bodies_.radius[k];
    g.mass[a] = row[R::mass];
    g.shape[a] = bodies_.shape[k];
    g.scale[a] = bodies_.scale[k];
    g.orientation[a] = bodies_.orientation(k);
    g.position[a] = vec3(row);
    Vec3 momentum;
    for (int c = 0; c < 3; ++c) {
      const auto e = static_cast<std::size_t>(c);
      g.velocity[a][c] = row[R::velocity + e] + force[c] * inverse[e] * (dt_ / 2);
      momentum[c] = bodies_.momentum[4 * k + e] + torque[c] * (dt_ / 2);
    }
    g.spin[a] = spin_of(bodies_, k, momentum);
    kinetic += 0.5 * (g.mass[a] * dot(g.velocity[a], g.velocity[a]) + dot(g.spin[a], momentum));
  }

  std::vector<Vec3> force_sum(n, Vec3{}), torque_sum(n, Vec3{});
  for (std::size_t k = 0; k < n; ++k) force_sum[k] = bodies_.row(k)[R::mass] * gravity_;
  ElasticEnergy energy;
  double scale = 0, turning_scale = 0;
  Contacts& c = out.contacts;
  const auto add = [&](std::size_t body, const Vec3& lever, const Vec3& force) {
    force_sum[body] += force;
    torque_sum[body] += cross(lever, force);
    scale = std::max(scale, norm(force));
    turning_scale = std::max(turning_scale, norm(force) * norm(lever));
  };
  const auto part_of = [&](std::uint32_t arm) {
    return static_cast<std::uint16_t>(arm - bodies_.first_arm[bodies_.arm_body[arm]]);
  };

  const PressRule rule{grain_law_, kind_, parallel_, parallel_sine2_, dt_};
  ArmContacts touching;
  touching.resize(pairs_.size());
  touching.count = plain_cluster_kernels().collect(collect_arrays(bodies_, pairs_, touching));
  if (duplicates_ == DuplicateRule::merge) merge_duplicates(bodies_, pairs_, rule, touching);
  for (std::size_t q = 0; q < touching.count; ++q) {
    const std::size_t k = touching.pair[q], i = pairs_.i[k], j = pairs_.j[k];
    const ArmTouch<double> t =
        touch_arms(parallel_, bodies_.arm(pairs_.arm_i[k]), bodies_.arm(pairs_.arm_j[k]), parallel_sine2_);
    const Vec3 lever_i = t.point - vec3(bodies_.row(i)), lever_j = t.point - vec3(bodies_.row(j));
    const Vec3 v = velocity_at(bodies_.row(i), lever_i) - velocity_at(bodies_.row(j), lever_j);
    const Vec3 force = append_forces<3, false>(c, energy, grain_law_, kind_,
                                               {t.normal, t.overlap, pairs_.mbar[k], v, {}, pairs_.spring(k)});
    add(i, lever_i, force);
    add(j, lever_j, -1.0 * force);
    c.i.push_back(bodies_.id[i]);
    c.j.push_back(static_cast<std::int32_t>(bodies_.id[j]));
    c.part_i.push_back(part_of(pairs_.arm_i[k]));
    c.part_j.push_back(part_of(pairs_.arm_j[k]));
    c.point.push_back(t.point);
    c.image.push_back({});
  }
  for (std::size_t q = 0; q < ends_.size(); ++q) {
    const ClusterWall& wall = walls_[ends_.wall[q]];
    const WallTouch t = touch_wall(wall, bodies_.arm(ends_.arm[q]), ends_.end[q]);
    if (!(t.overlap > 0)) continue;
    const std::size_t i = bodies_.arm_body[ends_.arm[q]];
    const double* row = bodies_.row(i);
    const Vec3 lever = t.point - vec3(row);
    Vec3 v = velocity_at(row, lever);
    v[wall.axis] -= wall.velocity;
    add(i, lever,
        append_forces<3, false>(c, energy, wall_law_, kind_,
                                {t.normal, t.overlap, row[R::mass], v, {}, ends_.spring[q]}));
    c.i.push_back(bodies_.id[i]);
    c.j.push_back(-1 - static_cast<std::int32_t>(ends_.wall[q]));
    c.part_i.push_back(part_of(ends_.arm[q]));
    c.part_j.push_back(ends_.end[q]);
    c.point.push_back(t.point);
    c.image.push_back({});
  }
  sort_contacts(c);

  for (std::size_t k = 0; k < n; ++k) {
    const Vec3 force = force_on(k), torque = vec3(bodies_.force(k) + 4);
    if (norm(force - force_sum[k]) > 1e-9 * (scale + norm(force)) ||
        norm(torque - torque_sum[k]) > 1e-9 * (turning_scale + norm(torque)))
      refuse_sums("body " + std::to_string(bodies_.id[k]), step_);
  }
  out.energy = ledger_of(booked_, kinetic, energy, kind_);
  return out;
}

ElasticEnergy ClusterEngine::elastic_energy() const {
  ElasticEnergy sum;
  ArmContacts touching;
  touching.resize(pairs_.size());
  touching.count = plain_cluster_kernels().collect(collect_arrays(bodies_, pairs_, touching));
  const PressRule rule{grain_law_, kind_, parallel_, parallel_sine2_, dt_};
  if (duplicates_ == DuplicateRule::merge) merge_duplicates(bodies_, pairs_, rule, touching);
  with_law(kind_, [&]<NormalLaw law>() {
    for (std::size_t q = 0; q < touching.count; ++q) {
      const std::size_t k = touching.pair[q];
      const double *one = bodies_.arm(pairs_.arm_i[k]), *two = bodies_.arm(pairs_.arm_j[k]);
      const double distance = std::sqrt(closest_points(axis_of(one), axis_of(two)).distance2);
      sum.add<law>(grain_law_, one[3] + two[3] - distance, pairs_.spring(k));
    }
    for (std::size_t q = 0; q < ends_.size(); ++q) {
      const double x = wall_overlap(walls_[ends_.wall[q]], bodies_.arm(ends_.arm[q]), ends_.end[q]);
      if (x > 0) sum.add<law>(wall_law_, x, ends_.spring[q]);
    }
  });
  return sum;
}

}  // namespace jam
