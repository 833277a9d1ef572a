#include "jamscape/io/packing_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "jamscape/base/error.hpp"
#include "jamscape/packing/cell.hpp"

namespace jam {
namespace {

constexpr double rounding = 1e-3;    // of two radii: what digits left out may open between two grains
constexpr double farthest = 1.5;     // of two radii: centres further apart cannot be of grains that touch
constexpr double few_degrees = 0.1;  // radians
constexpr std::size_t some = 4;      // contacts, too many to be all of one sign by chance

bool any_periodic(const Packing& p) {
  for (int k = 0; k < p.dimension; ++k)
    if (p.domain.periodic[static_cast<std::size_t>(k)]) return true;
  return false;
}

class ContactCheck {
 public:
  ContactCheck(Packing& packing, const StatedContacts& stated, const PackingPlaces& places,
               std::vector<std::string>& notes)
      : p_(packing), c_(packing.contacts), stated_(stated), places_(places), notes_(notes) {}

  void run() {
    for (std::size_t m = 0; m < c_.size(); ++m) mean_ += std::hypot(c_.normal_force[m], norm(c_.tangential_force[m]));
    if (c_.size() > 0) mean_ /= static_cast<double>(c_.size());
    for (std::size_t m = 0; m < c_.size(); ++m) {
      if (m > 0 && c_.j[m] >= 0 && c_.i[m] == c_.i[m - 1] && c_.j[m] == c_.j[m - 1] && c_.image[m] != c_.image[m - 1])
        refuse_both_sides(m);
      if (stated_.point) check_point(m);
      c_.j[m] < 0 ? check_wall(m) : check_pair(m);
      negative_ += c_.normal_force[m] < 0;
      positive_ += c_.normal_force[m] > 0;
      if (stated_.tangential) across_ = std::max(across_, std::abs(dot(c_.tangential_force[m], c_.normal[m])));
    }
    refuse_signs();
    say();
  }

 private:
  Vec3 lever(std::size_t m) const {
    return p_.grains.position[static_cast<std::size_t>(c_.j[m])] - p_.grains.position[c_.i[m]] +
           image_shift(p_.domain, c_.image[m]);
  }

  std::string bodies(std::size_t m) const {
    const auto& id = p_.grains.id;
    if (c_.j[m] < 0) return fmt::format("grain {} and wall {}", id[c_.i[m]], -1 - c_.j[m]);
    return fmt::format("grains {} and {}", id[c_.i[m]], id[static_cast<std::size_t>(c_.j[m])]);
  }

  [[noreturn]] void refuse_both_sides(std::size_t m) const {
    int axis = 0;
    while (c_.image[m][static_cast<std::size_t>(axis)] == c_.image[m - 1][static_cast<std::size_t>(axis)]) ++axis;
    throw data_error(
        fmt::format("{} touch through both sides of the periodic box, which is only {:.6g} wide along {}: they would "
                    "be one edge of the network",
                    bodies(m), faces_.width(axis), "xyz"[axis]),
        places_.contact(m), fmt::format("give the packing twice, side by side along {}", "xyz"[axis]));
  }

  void check_point(std::size_t m) {
    const Vec3 centre = p_.grains.position[c_.i[m]];
    for (int k = 0; k < p_.dimension; ++k)
      if (p_.domain.periodic[static_cast<std::size_t>(k)]) {
        const double apart = faces_.above_low(k, c_.point[m]) - faces_.above_low(k, centre),
                     boxes = std::round(apart / faces_.width(k));
        if (boxes != 0) c_.point[m] -= boxes * p_.domain.edge(k);
      }
    const Vec3 arm = c_.point[m] - centre;
    if (norm(arm) > 2 * p_.grains.radius[c_.i[m]])
      throw data_error(fmt::format("the point of the contact of {} lies {:.4g} from the centre of grain {}, whose "
                                   "radius is {:.4g}",
                                   bodies(m), norm(arm), p_.grains.id[c_.i[m]], p_.grains.radius[c_.i[m]]),
                       places_.contact(m),
                       "points stand in the coordinates of the packing; leave their columns out if yours do not");
  }

  void check_wall(std::size_t m) {
    const Wall& wall = p_.walls[static_cast<std::size_t>(-1 - c_.j[m])];
    const Vec3 arm = c_.point[m] - p_.grains.position[c_.i[m]];
    const bool into_plane =
        wall.kind != WallKind::plane || norm(wall.normal) == 0 || dot(c_.normal[m], wall.normal) < .5;
    const bool to_point = !stated_.point || !p_.shapes.empty() || dot(c_.normal[m], arm) > -.5 * norm(arm);
    if (stated_.normal && !(into_plane && to_point)) turned(m);
  }

  void check_pair(std::size_t m) {
    const Vec3 l = lever(m);
    const double apart = norm(l),
                 reach = p_.grains.radius[c_.i[m]] + p_.grains.radius[static_cast<std::size_t>(c_.j[m])];
    if (!(apart <= farthest * reach)) refuse_lever(m, apart, reach);
    if (stated_.overlap) {
      open_ += c_.overlap[m] < 0;
      pressed_open_ += c_.overlap[m] < 0 && c_.normal_force[m] > 0;
    } else if (c_.overlap[m] < 0) {
      if (c_.normal_force[m] == 0 && norm(c_.tangential_force[m]) == 0 && c_.overlap[m] < -rounding * reach) {
        ++neighbours_;
      } else {
        ++believed_;
        gap_ = std::max(gap_, -c_.overlap[m] / reach);
        c_.overlap[m] = 0;
      }
    }
    ++pairs_;
    if (!stated_.normal || !p_.shapes.empty() || apart == 0) return;
    const double cosine = dot(c_.normal[m], l) / apart;
    least_cosine_ = std::min(least_cosine_, cosine);
    if (cosine < 0) turned(m);
  }

  void turned(std::size_t m) {
    if (turned_++ == 0) first_turned_ = m;
  }

  [[noreturn]] void refuse_lever(std::size_t m, double apart, double reach) const {
    throw data_error(
        fmt::format("{} are listed as touching, but their centres are {:.4g} apart and their radii add up to {:.4g}",
                    bodies(m), apart, reach),
        places_.contact(m),
        any_periodic(p_) ? "check box, images, and that both tables are of the same frame"
                         : "check that both tables are of the same frame; a periodic box is given by '# lo: x y z', '# "
                           "hi: x y z' and "
                           "'# periodic: 1 1 0' on top of the table of particles");
  }

  void refuse_signs() const {
    if (turned_ > 0)
      throw data_error(
          turned_ * 2 > pairs_ && turned_ > 1
              ? fmt::format("{} of {} normals point away from what the grain touches", turned_, c_.size())
              : fmt::format("the normal of the contact of {} points away from what the grain touches",
                            bodies(first_turned_)),
          places_.contact(first_turned_),
          "nx, ny (and nz) point from id1 to id2; if yours point from id2 to id1, swap the two columns of ids or the "
          "signs");
    if (positive_ == 0 && negative_ > 0 && (stated_.force_vector || negative_ >= some))
      throw data_error(fmt::format("all forces pull: {} normal force{} below 0 and none above", negative_,
                                   negative_ == 1 ? " is" : "s are"),
                       places_.contact(0),
                       stated_.force_vector
                           ? "fx, fy (and fz) are the force on id1, which is pushed away from id2"
                           : "normal forces are positive where grains push each other: turn their sign");
    if (stated_.overlap && open_ == pairs_ && pressed_open_ > 0)
      throw data_error(fmt::format("all overlaps are below 0, so none of {} contacts touches", pairs_),
                       places_.contact(0), "overlaps are positive where grains touch: turn their sign");
  }

  void say() const {
    if (believed_ > 0)
      notes_.push_back(
          fmt::format("{} of {} listed contacts have a gap at the positions given, up to {:.2g} of the two radii: they "
                      "are taken to touch, with overlap 0",
                      believed_, pairs_, gap_));
    if (neighbours_ > 0)
      notes_.push_back(fmt::format("{} of {} listed pairs carry no force and are apart: they do not count as contacts",
                                   neighbours_, pairs_));
    if (pressed_open_ > 0)
      notes_.push_back(
          fmt::format("{} contacts push with an overlap below 0: they count, for the force they carry", pressed_open_));
    if (least_cosine_ < std::cos(few_degrees))
      notes_.push_back(fmt::format("normals are up to {:.0f} degrees off the lines of centres: taken as given",
                                   std::acos(least_cosine_) * 180 / std::numbers::pi));
    if (across_ > rounding * mean_)
      notes_.push_back(fmt::format(
          "tangential forces have a part along the normal, up to {:.3g} mean forces: taken as given", across_ / mean_));
  }

  Packing& p_;
  Faces faces_{p_.domain, p_.dimension};
  Contacts& c_;
  const StatedContacts& stated_;
  const PackingPlaces& places_;
  std::vector<std::string>& notes_;
  std::size_t pairs_ = 0, open_ = 0, pressed_open_ = 0, believed_ = 0, neighbours_ = 0, turned_ = 0, first_turned_ = 0;
  std::size_t negative_ = 0, positive_ = 0;
  double mean_ = 0, gap_ = 0, least_cosine_ = 1, across_ = 0;
};

/// The number of boxes by which a grain lies outside; a grain that is merely crossing the border stays.
Vec3 boxes_outside(const Packing& p, const Faces& faces, std::size_t grain) {
  Vec3 boxes{};
  for (int k = 0; k < p.dimension; ++k) {
    if (!p.domain.periodic[static_cast<std::size_t>(k)]) continue;
    const Vec3& x = p.grains.position[grain];
    const double above = faces.above_low(k, x), r = p.grains.radius[grain];
    if (above < -r || faces.below_high(k, x) < -r) boxes[k] = std::floor(above / faces.width(k));
  }
  return boxes;
}

void wrap(Packing& p, std::vector<std::string>& notes) {
  if (!any_periodic(p)) return;
  std::size_t moved = 0;
  const Faces faces(p.domain, p.dimension);
  std::vector<Vec3> boxes(p.grains.size());
  for (std::size_t n = 0; n < p.grains.size(); ++n) {
    boxes[n] = boxes_outside(p, faces, n);
    moved += norm(boxes[n]) > 0;
  }
  if (moved == 0) return;
  Contacts& c = p.contacts;
  for (int k = 0; k < p.dimension; ++k) {
    const auto d = static_cast<std::size_t>(k);
    const Vec3 edge = p.domain.edge(k);
    for (std::size_t n = 0; n < p.grains.size(); ++n)
      if (boxes[n][k] != 0) p.grains.position[n] -= boxes[n][k] * edge;
    for (std::size_t m = 0; m < c.size(); ++m) {
      if (boxes[c.i[m]][k] != 0) c.point[m] -= boxes[c.i[m]][k] * edge;
      if (c.j[m] >= 0)
        c.image[m][d] =
            static_cast<std::int8_t>(c.image[m][d] + boxes[static_cast<std::size_t>(c.j[m])][k] - boxes[c.i[m]][k]);
    }
  }
  notes.push_back(fmt::format("{} grains lie outside the periodic box: moved into it by whole boxes", moved));
}

}  // namespace

void check_grains(const Packing& p, const PackingPlaces& places) {
  if (p.grains.size() == 0) throw data_error("there are no grains", places.box);
  const Faces faces(p.domain, p.dimension);
  for (int k = 0; k < p.dimension; ++k)
    if (!(faces.width(k) > 0))
      throw data_error(fmt::format("the box has no room along {}: it reaches from {:.6g} to {:.6g}", "xyz"[k],
                                   p.domain.lo[k], p.domain.hi[k]),
                       places.box, "'# lo' holds the lower corner, '# hi' the upper one");
  for (std::size_t n = 0; n < p.grains.size(); ++n) {
    const auto& id = p.grains.id[n];
    if (!(p.grains.radius[n] > 0))
      throw data_error(fmt::format("grain {} has the radius {:.6g}", id, p.grains.radius[n]), places.grain(n),
                       "sizes are above 0");
    if (!(p.grains.mass[n] > 0))
      throw data_error(fmt::format("grain {} has the mass {:.6g}", id, p.grains.mass[n]), places.grain(n),
                       "masses are above 0; without their column, one material is assumed");
    for (int k = 0; k < p.dimension; ++k) {
      const Vec3& place = p.grains.position[n];
      const double x = place[k], slack = 1e-6 * faces.width(k);
      if (p.domain.periodic[static_cast<std::size_t>(k)] ||
          (faces.above_low(k, place) >= -slack && faces.below_high(k, place) >= -slack))
        continue;
      throw data_error(fmt::format("grain {} lies outside the box: {} = {:.6g} is not from {:.6g} to {:.6g}", id,
                                   "xyz"[k], x, p.domain.lo[k], p.domain.hi[k]),
                       places.grain(n),
                       "correct '# lo' and '# hi', or leave out both: the box is then put around the grains");
    }
  }
}

void check_contacts(Packing& packing, const StatedContacts& stated, const PackingPlaces& places,
                    std::vector<std::string>& notes) {
  ContactCheck(packing, stated, places, notes).run();
  wrap(packing, notes);
}

}  // namespace jam
