#include "jamscape/observe/stress.hpp"

#include "jamscape/observe/box.hpp"
#include "jamscape/observe/entry.hpp"

namespace jam {

std::array<Vec3, 3> stress(const Packing& packing) {
  const Contacts& k = packing.contacts;
  const Grains& g = packing.grains;
  const Vec3 side = packing.domain.hi - packing.domain.lo;
  double xx = 0, xy = 0, xz = 0, yx = 0, yy = 0, yz = 0, zx = 0, zy = 0, zz = 0;  // in registers: sums wait for nothing
  for (std::size_t c = 0; c < k.size(); ++c) {
    const Vec3& n = k.normal[c];
    const Vec3& t = k.tangential_force[c];
    const double fn = k.normal_force[c];
    const double fx = t[0] - fn * n[0], fy = t[1] - fn * n[1], fz = t[2] - fn * n[2];
    const Vec3& at = g.position[k.i[c]];
    double lx, ly, lz;
    if (k.j[c] < 0) {
      const Vec3& p = k.point[c];
      lx = p[0] - at[0], ly = p[1] - at[1], lz = p[2] - at[2];
    } else {
      const Vec3& p = g.position[static_cast<std::size_t>(k.j[c])];
      const auto& image = k.image[c];
      lx = p[0] - at[0] + image[0] * side[0];
      ly = p[1] - at[1] + image[1] * side[1];
      lz = p[2] - at[2] + image[2] * side[2];
    }
    xx += fx * lx, xy += fx * ly, xz += fx * lz;
    yx += fy * lx, yy += fy * ly, yz += fy * lz;
    zx += fz * lx, zy += fz * ly, zz += fz * lz;
  }
  std::array<Vec3, 3> sigma = {Vec3{xx, xy, xz}, Vec3{yx, yy, yz}, Vec3{zx, zy, zz}};
  const double volume = box_volume(packing);
  for (Vec3& row : sigma) row = (volume > 0 ? 1 / volume : 0.0) * row;
  return sigma;
}

Measure stress_measure() {
  const char* unit = "m d^(2-D)/tau_c^2";
  return frame_measure(
      {"stress", "mean contact stress",
       "sigma_ab = (1/V) sum_c f_a l_b, f the force on a grain, l from its centre to the contact point, wall contacts "
       "included, V the space between the walls (bead-centre lines for bead walls). Negative trace in compression; "
       "pressure = -trace/D. Off-diagonal elements are symmetrised; elements with z are 0 in two dimensions.",
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
