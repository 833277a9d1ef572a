#include "jamscape/report/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace jam {
namespace {

double mean_force_between_grains(const Contacts& contacts) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (contacts.j[c] < 0 || contacts.overlap[c] < 0) continue;
    sum += std::abs(contacts.normal_force[c]);
    ++count;
  }
  return count ? sum / static_cast<double>(count) : 0;
}

std::array<double, 4> extent_of(const Packing& p) {
  double margin = 0;
  for (const Wall& wall : p.walls) margin = std::max(margin, wall.bead_radius);
  return {p.domain.lo[0] - margin, p.domain.lo[1] - margin, p.domain.hi[0] + margin, p.domain.hi[1] + margin};
}

class Sketch {
 public:
  explicit Sketch(const Packing& packing) : p_(packing) {
    d_.extent = extent_of(p_);
    for (std::size_t k = 0; k < p_.grains.size(); ++k) node(p_.grains.position[k], p_.grains.radius[k]);
    d_.grains = d_.x.size();
    add_beads();
    d_.beads = d_.x.size() - d_.grains;
  }

  Drawing finish() {
    const double mean = mean_force_between_grains(p_.contacts);
    for (std::size_t c = 0; mean > 0 && c < p_.contacts.size(); ++c)
      if (p_.contacts.normal_force[c] > 0) add_contact(c, p_.contacts.normal_force[c] / mean);
    return std::move(d_);
  }

 private:
  std::uint32_t node(const Vec3& at, double radius) {
    d_.x.push_back(at[0]);
    d_.y.push_back(at[1]);
    d_.radius.push_back(radius);
    return static_cast<std::uint32_t>(d_.x.size() - 1);
  }

  /// Rows of beads go on beyond the corners; only those that show are kept.
  void add_beads() {
    for (std::size_t w = 0; w < p_.walls.size(); ++w)
      for (std::size_t b = 0; b < p_.walls[w].beads.size(); ++b) {
        const Vec3& at = p_.walls[w].beads[b];
        const double r = p_.walls[w].bead_radius;
        if (at[0] + r <= d_.extent[0] || at[0] - r >= d_.extent[2] || at[1] + r <= d_.extent[1] ||
            at[1] - r >= d_.extent[3])
          continue;
        bead_[{w, b}] = node(at, r);
      }
  }

  void line(std::uint32_t from, std::uint32_t to, double force) {
    d_.ends.push_back(from);
    d_.ends.push_back(to);
    d_.force.push_back(force);
  }

  void add_contact(std::size_t c, double force) {
    const std::uint32_t i = p_.contacts.i[c];
    const std::int32_t j = p_.contacts.j[c];
    if (j < 0) {
      const auto w = static_cast<std::size_t>(-1 - j);
      const auto bead = bead_.find({w, p_.contacts.part_j[c]});
      line(i, bead != bead_.end() ? bead->second : node(p_.contacts.point[c], 0), force);
      return;
    }
    const auto& image = p_.contacts.image[c];
    const auto other = static_cast<std::uint32_t>(j);
    if (image[0] == 0 && image[1] == 0) {
      line(i, other, force);
      return;
    }
    Vec3 shift{};
    for (int k = 0; k < 2; ++k) shift[k] = image[static_cast<std::size_t>(k)] * (p_.domain.hi[k] - p_.domain.lo[k]);
    line(i, node(p_.grains.position[other] + shift, 0), force);
    line(other, node(p_.grains.position[i] - shift, 0), force);
  }

  const Packing& p_;
  Drawing d_;
  std::map<std::pair<std::size_t, std::size_t>, std::uint32_t> bead_;
};

}  // namespace

Drawing drawing(const Packing& packing) { return Sketch(packing).finish(); }

}  // namespace jam
