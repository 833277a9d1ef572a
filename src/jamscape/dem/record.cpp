// The full record of an instant: every contact by the same law function the kernels use, checked against their sums.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "jamscape/dem/contact_record.hpp"
#include "jamscape/dem/engine.hpp"
#include "jamscape/dem/spin.hpp"

namespace jam {

template <int D>
Packing Engine<D>::record() {
  using R = Row<D>;
  compute_forces();
  check_inside();
  Packing out;
  out.dimension = D;
  out.step = step_;
  out.time = time();
  for (int c = 0; c < D; ++c) {
    const auto e = static_cast<std::size_t>(c);
    if (box_.length[e] > 0) {
      out.domain.lo[c] = box_.lo[e];
      out.domain.hi[c] = box_.lo[e] + box_.length[e];
      out.domain.periodic[e] = true;
    }
  }
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const EngineWall<D>& from = walls_[w];
    (from.high ? out.domain.hi : out.domain.lo)[from.axis] = from.position;
    Wall wall;
    wall.kind = from.kind;
    wall.position[from.axis] = from.position;
    wall.normal[from.axis] = from.high ? -1 : 1;
    wall.velocity[from.axis] = from.velocity;
    wall.force = widen<D>(wall_force_[w]);
    wall.bead_radius = from.bead_radius;
    for (std::size_t b = 0; b < from.beads.size(); ++b)
      wall.beads.push_back(widen<D>(bodies_.position(first_bead_[w] + b)));
    out.walls.push_back(wall);
  }

  // Grains by id. Verlet rows hold the velocity half a step ago.
  Grains& g = out.grains;
  const std::size_t n = bodies_.grains;
  g.id.resize(n), g.species.resize(n), g.radius.resize(n), g.mass.resize(n);
  g.position.resize(n), g.velocity.resize(n), g.spin.resize(n), g.angle.resize(n);
  double kinetic = 0;
  const double half = scheme_ == Scheme::verlet ? dt_ / 2 : 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t a = bodies_.id[k];
    const double* row = bodies_.row(k);
    const double* force = bodies_.forces.data() + k * R::force_stride;
    g.id[a] = static_cast<std::int64_t>(a);
    g.species[a] = bodies_.species[k];
    g.radius[a] = row[R::radius];
    g.mass[a] = bodies_.mass[k];
    for (int c = 0; c < D; ++c) {
      const auto e = static_cast<std::size_t>(c);
      g.position[a][c] = row[e];
      g.velocity[a][c] = row[R::velocity + e] + force[e] * bodies_.inverse_mass(k) * half;
      kinetic += 0.5 * g.mass[a] * g.velocity[a][c] * g.velocity[a][c];
    }
    for (int c = D == 2 ? 2 : 0; c < 3; ++c) {
      const std::size_t at = D == 2 ? 0 : static_cast<std::size_t>(c), f = D == 2 ? 2 : 4 + at;
      g.spin[a][c] = row[R::spin + at] + force[f] * bodies_.inverse_inertia(k) * half;
      g.angle[a][c] = row[R::angle + at];
      kinetic += 0.5 * g.spin[a][c] * g.spin[a][c] / bodies_.inverse_inertia(k);
    }
  }

  std::vector<Vec<D>> sums(n, Vec<D>{});
  for (std::size_t k = 0; k < n; ++k) sums[bodies_.id[k]] = bodies_.mass[k] * gravity_;
  ElasticEnergy energy;
  double scale = 0;
  Contacts& c = out.contacts;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    std::uint32_t i = pairs_.i[k], j = pairs_.j[k];
    if (i >= n) continue;
    const bool bead = j >= n;
    const double *a = bodies_.row(i), *b = bodies_.row(j);
    Vec<D> d;
    for (int e = 0; e < D; ++e) {
      const auto u = static_cast<std::size_t>(e);
      d[e] = (bead ? b[u] : b[u] + shifts_[4 * pairs_.shift[k] + u]) - a[u];
    }
    const double r2 = dot<fused<D>>(d, d), reach = a[R::radius] + b[R::radius];
    if (!(r2 < reach * reach)) continue;
    const PairLaw<>& law = bead ? wall_law_ : grain_law_;
    const double r = std::sqrt(r2);
    Touching<D> t;
    t.n = (1 / r) * d;
    t.x = reach - r;
    t.mbar = pairs_.mbar[k];
    t.lw =
        levered_spin<D>(a, a[R::radius] - law.lever_cut * t.x) + levered_spin<D>(b, b[R::radius] - law.lever_cut * t.x);
    for (int e = 0; e < D; ++e) {
      t.v[e] = a[R::velocity + static_cast<std::size_t>(e)] - b[R::velocity + static_cast<std::size_t>(e)];
      if (box_speed_ != 0) t.v[e] = add_product<fused<D>>(t.v[e], shrinking(), d[e]);
    }
    if constexpr (D == 2)
      t.spring = *pairs_.spring(k);
    else
      t.spring = {pairs_.spring(k)[0], pairs_.spring(k)[block], pairs_.spring(k)[2 * block]};
    const Vec<D> force = append_forces<D, fused<D>>(c, energy, law, kind_, t);
    sums[bodies_.id[i]] += force;
    if (!bead) sums[bodies_.id[j]] -= force;
    scale = std::max(scale, norm(force));

    c.point.push_back(widen<D>(bodies_.position(i) + (a[R::radius] - t.x / 2) * t.n));
    c.part_i.push_back(0);
    auto image = bead ? std::array<std::int8_t, 3>{} : image_of<D>(pairs_.shift[k]);
    if (bead) {
      std::size_t w = walls_.size() - 1;
      while (first_bead_[w] > j) --w;
      c.i.push_back(bodies_.id[i]);
      c.j.push_back(-1 - static_cast<std::int32_t>(w));
      c.part_j.push_back(static_cast<std::uint16_t>(j - first_bead_[w]));
    } else {
      std::uint32_t id_i = bodies_.id[i], id_j = bodies_.id[j];
      if (id_i > id_j) {  // stored with i < j: seen from the other side
        std::swap(id_i, id_j);
        c.normal.back() = -1.0 * c.normal.back();
        c.tangential_force.back() = -1.0 * c.tangential_force.back();
        c.point.back() = widen<D>(bodies_.position(j) - (b[R::radius] - t.x / 2) * t.n);
        for (auto& s : image) s = static_cast<std::int8_t>(-s);
      }
      c.i.push_back(id_i);
      c.j.push_back(static_cast<std::int32_t>(id_j));
      c.part_j.push_back(0);
    }
    c.image.push_back(image);
  }
  for (std::size_t q = 0; q < plane_grain_.size(); ++q) {
    const std::size_t i = plane_grain_[q], w = plane_wall_[q];
    const EngineWall<D>& wall = walls_[w];
    const double* a = bodies_.row(i);
    const double sign = wall.high ? -1.0 : 1.0, x = a[R::radius] - sign * (a[wall.axis] - wall.position);
    if (!(x > 0)) continue;
    Touching<D> t{};
    t.n[wall.axis] = -sign;
    t.x = x;
    t.mbar = bodies_.mass[i];
    t.lw = levered_spin<D>(a, a[R::radius] - wall_law_.lever_cut * x);
    for (int e = 0; e < D; ++e) t.v[e] = a[R::velocity + static_cast<std::size_t>(e)];
    t.v[wall.axis] -= wall.velocity;
    t.spring = plane_spring_[q];
    const Vec<D> force = append_forces<D, fused<D>>(c, energy, wall_law_, kind_, t);
    sums[bodies_.id[i]] += force;
    scale = std::max(scale, norm(force));
    c.point.push_back(widen<D>(bodies_.position(i) + (a[R::radius] - x / 2) * t.n));
    c.i.push_back(bodies_.id[i]);
    c.j.push_back(-1 - static_cast<std::int32_t>(w));
    c.part_i.push_back(0), c.part_j.push_back(0), c.image.push_back({});
  }
  sort_contacts(c);

  for (std::size_t k = 0; k < n; ++k)
    for (int e = 0; e < D; ++e) {
      const double summed = bodies_.forces[k * R::force_stride + static_cast<std::size_t>(e)];
      if (std::abs(summed - sums[bodies_.id[k]][e]) > 1e-9 * (scale + std::abs(summed)))
        refuse_sums("grain " + std::to_string(bodies_.id[k]), step_);
    }
  out.energy = ledger_of(booked_, kinetic, energy, kind_);
  return out;
}

template Packing Engine<2>::record();
template Packing Engine<3>::record();

}  // namespace jam
