#include "jamscape/observe/stress.hpp"

#include "jamscape/observe/box.hpp"
#include "jamscape/observe/entry.hpp"
#include "jamscape/packing/cell.hpp"

namespace jam {

namespace {

/// Sums of f_a l_b over the contacts, in registers, so that no sum waits for memory; in the plane four of the nine.
template <int D, bool tilted>
std::array<Vec3, 3> sum_over_contacts(const Packing& packing) {
  const Contacts& k = packing.contacts;
  const Grains& g = packing.grains;
  const Vec3 side = packing.domain.hi - packing.domain.lo;
  double xx = 0, xy = 0, xz = 0, yx = 0, yy = 0, yz = 0, zx = 0, zy = 0, zz = 0;
  for (std::size_t c = 0; c < k.size(); ++c) {
    const Vec3& n = k.normal[c];
    const Vec3& t = k.tangential_force[c];
    const double fn = k.normal_force[c];
    const Vec3& at = g.position[k.i[c]];
    const bool wall = k.j[c] < 0;
    const Vec3& to = wall ? k.point[c] : g.position[static_cast<std::size_t>(k.j[c])];
    const auto& image = k.image[c];
    const Vec3 shift = tilted && !wall ? image_shift(packing.domain, image) : Vec3{};
    const auto arm = [&](int a) {
      const double l = to[a] - at[a];
      if constexpr (tilted) return l + shift[a];
      return wall ? l : l + image[static_cast<std::size_t>(a)] * side[a];
    };
    const double fx = t[0] - fn * n[0], fy = t[1] - fn * n[1];
    const double lx = arm(0), ly = arm(1);
    xx += fx * lx, xy += fx * ly;
    yx += fy * lx, yy += fy * ly;
    if constexpr (D == 3) {
      const double fz = t[2] - fn * n[2], lz = arm(2);
      xz += fx * lz, yz += fy * lz;
      zx += fz * lx, zy += fz * ly, zz += fz * lz;
    }
  }
  return {Vec3{xx, xy, xz}, Vec3{yx, yy, yz}, Vec3{zx, zy, zz}};
}

}  // namespace

std::array<Vec3, 3> stress(const Packing& packing) {
  auto sigma = packing.domain.upright() ? packing.dimension == 2 ? sum_over_contacts<2, false>(packing)
                                                                 : sum_over_contacts<3, false>(packing)
               : packing.dimension == 2 ? sum_over_contacts<2, true>(packing)
                                        : sum_over_contacts<3, true>(packing);
  const double volume = box_volume(packing);
  for (Vec3& row : sigma) row = (volume > 0 ? 1 / volume : 0.0) * row;
  return sigma;
}

Measure stress_measure() {
  const char* unit = "m d^(2-D)/tau_c^2";
  return frame_measure(
      {"stress", "mean contact stress",
       "sigma_ab = (1/V) sum over grains and their contacts of f_a l_b, f the force on the grain, l from its centre to "
       "the "
       "contact point; a contact between grains adds f_a (x_j - x_i)_b, f on i, the copy of j that touches; wall "
       "contacts included. V: area (volume) between the walls, of bead walls between the lines of bead centres, of a "
       "periodic box all of it, of a cylinder pi R^2 times its length; the same V in kinetic_stress, solid_fraction, "
       "radial_distribution and wall_virial_pressure, whatever domain.box says of the packing fraction. Negative trace "
       "in compression; pressure = -trace/D, contacts alone (kinetic_stress has the rest). Off-diagonal elements are "
       "symmetrised; elements with z are 0 in two dimensions.",
       "S3 Eq. 8; theory sec. 4"},
      {{"stress_xx", unit, "negative in compression"},
       {"stress_yy", unit, "negative in compression"},
       {"stress_xy", unit, "shear stress"},
       {"stress_zz", unit, "negative in compression; 0 in two dimensions"},
       {"stress_xz", unit, "shear stress; 0 in two dimensions"},
       {"stress_yz", unit, "shear stress; 0 in two dimensions"},
       {"pressure", unit, "-(trace of the stress)/D, positive in compression"}},
      [](const Snapshot& s) {
        const auto t = stress(s.packing());
        const auto shear = [&](std::size_t a, std::size_t b) {
          return 0.5 * (t[a][static_cast<int>(b)] + t[b][static_cast<int>(a)]);
        };
        const double trace = t[0][0] + t[1][1] + t[2][2];
        return std::vector<double>{
            t[0][0], t[1][1], shear(0, 1), t[2][2], shear(0, 2), shear(1, 2), (0 - trace) / s.packing().dimension};
      });
}

}  // namespace jam
