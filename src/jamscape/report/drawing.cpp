#include "jamscape/report/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "jamscape/observe/force_network.hpp"
#include "jamscape/observe/particle_stress.hpp"

namespace jam {
namespace {

double contact_force(const Contacts& contacts, std::size_t c, EdgeForce kind) {
  const double normal = std::abs(contacts.normal_force[c]);
  return kind == EdgeForce::total ? std::hypot(normal, norm(contacts.tangential_force[c])) : normal;
}

class Sketch {
 public:
  explicit Sketch(const Packing& packing) : p_(packing) {
    d_.dimension = p_.dimension;
    double margin = 0;
    for (const Wall& wall : p_.walls) margin = std::max(margin, wall.bead_radius);
    for (int a = 0; a < p_.dimension; ++a) {
      d_.lower[a] = p_.domain.lo[a] - margin;
      d_.upper[a] = p_.domain.hi[a] + margin;
    }
    for (std::size_t k = 0; k < p_.grains.size(); ++k) node(wrapped(p_.grains.position[k]), p_.grains.radius[k]);
    d_.grains = d_.position.size();
    add_beads();
    d_.beads = d_.position.size() - d_.grains;
    if (!p_.shapes.empty()) add_shapes();
  }

  /// Forces in units of the network's mean.
  Drawing finish(MeasureOptions options) {
    options.clamp = 0;
    const ForceNetwork network = force_network(p_, find_bonds(p_), options);
    if (!p_.shapes.empty())
      add_pairs(network, options.force);
    else
      for (std::size_t c = 0; network.mean_force > 0 && c < p_.contacts.size(); ++c)
        if (p_.contacts.normal_force[c] > 0)
          add_contact(c, contact_force(p_.contacts, c, options.force) / network.mean_force);
    return std::move(d_);
  }

 private:
  bool periodic(int axis) const { return p_.domain.periodic[static_cast<std::size_t>(axis)]; }
  double side(int axis) const { return p_.domain.hi[axis] - p_.domain.lo[axis]; }

  Vec3 wrapped(Vec3 at) const {
    for (int a = 0; a < p_.dimension; ++a)
      if (periodic(a)) at[a] -= std::floor((at[a] - p_.domain.lo[a]) / side(a)) * side(a);
    return at;
  }

  /// Containers of clusters end at a lid, which is far above them until they have settled.
  void add_shapes() {
    d_.shapes = p_.shapes;
    d_.shape = p_.grains.shape;
    d_.orientation = p_.grains.orientation;
    d_.stress = stress_ratios(particle_stresses(p_));
    double top = d_.lower[1];
    for (std::size_t k = 0; k < d_.grains; ++k) top = std::max(top, d_.position[k][1] + d_.radius[k]);
    d_.upper[1] = std::min(d_.upper[1], top);
    for (const Wall& wall : p_.walls) {
      if (wall.kind != WallKind::cylinder) continue;
      const auto along = [&](int axis) { return std::abs(wall.normal[axis]); };
      const int axis = along(0) > along(1) ? (along(0) > along(2) ? 0 : 2) : (along(1) > along(2) ? 1 : 2);
      d_.cylinder = Drawing::Cylinder{axis, wall.position, wall.radius};
    }
  }

  void add_pairs(const ForceNetwork& network, EdgeForce kind) {
    for (std::size_t e = 0; e < network.contact.size(); ++e) add_contact(network.contact[e], network.graph.weight[e]);
    for (std::size_t c = 0; network.mean_force > 0 && c < p_.contacts.size(); ++c)
      if (p_.contacts.j[c] < 0 && p_.contacts.normal_force[c] > 0)
        add_contact(c, contact_force(p_.contacts, c, kind) / network.mean_force);
  }

  std::uint32_t node(const Vec3& at, double radius) {
    d_.position.push_back(at);
    d_.radius.push_back(radius);
    return static_cast<std::uint32_t>(d_.position.size() - 1);
  }

  /// Rows of beads go on beyond the corners; only those that show are kept.
  void add_beads() {
    for (std::size_t w = 0; w < p_.walls.size(); ++w)
      for (std::size_t b = 0; b < p_.walls[w].beads.size(); ++b) {
        const Vec3& at = p_.walls[w].beads[b];
        const double r = p_.walls[w].bead_radius;
        bool shows = true;
        for (int a = 0; a < p_.dimension; ++a) shows = shows && at[a] + r > d_.lower[a] && at[a] - r < d_.upper[a];
        if (shows) bead_[{w, b}] = node(at, r);
      }
  }

  void line(std::uint32_t from, std::uint32_t to, double force) {
    d_.ends.push_back(from);
    d_.ends.push_back(to);
    d_.force.push_back(force);
  }

  /// From a grain along `way` to where the line leaves the box.
  void line_out(std::uint32_t from, const Vec3& way, double force) {
    const Vec3& start = d_.position[from];
    double part = 1;
    for (int a = 0; a < p_.dimension; ++a) {
      if (!periodic(a)) continue;
      const double end = start[a] + way[a];
      if (end > p_.domain.hi[a]) part = std::min(part, (p_.domain.hi[a] - start[a]) / way[a]);
      if (end < p_.domain.lo[a]) part = std::min(part, (p_.domain.lo[a] - start[a]) / way[a]);
    }
    line(from, node(start + part * way, 0), force);
  }

  void add_contact(std::size_t c, double force) {
    const std::uint32_t i = p_.contacts.i[c];
    const std::int32_t j = p_.contacts.j[c];
    if (j < 0) {
      const auto w = static_cast<std::size_t>(-1 - j);
      const auto bead = bead_.find({w, p_.contacts.part_j[c]});
      line(i, bead != bead_.end() ? bead->second : node(wrapped(p_.contacts.point[c]), 0), force);
      return;
    }
    const auto other = static_cast<std::uint32_t>(j);
    Vec3 way = p_.grains.position[other] - p_.grains.position[i];
    for (int a = 0; a < p_.dimension; ++a)
      if (periodic(a)) way[a] += p_.contacts.image[c][static_cast<std::size_t>(a)] * side(a);
    // Two grains that are as far apart in the picture as they are in truth are joined by one line.
    const Vec3 off = d_.position[other] - d_.position[i] - way;
    if (norm(off) < 1e-6) {
      line(i, other, force);
      return;
    }
    line_out(i, way, force);
    line_out(other, -1.0 * way, force);
  }

  const Packing& p_;
  Drawing d_;
  std::map<std::pair<std::size_t, std::size_t>, std::uint32_t> bead_;
};

}  // namespace

Drawing drawing(const Packing& packing, const MeasureOptions& options) { return Sketch(packing).finish(options); }

Drawing drawing(const Packing& packing, EdgeForce force) {
  MeasureOptions options;
  options.force = force;
  return drawing(packing, options);
}

}  // namespace jam
