#include "jamscape/observe/stress.hpp"

#include "jamscape/observe/box.hpp"
#include "jamscape/observe/entry.hpp"

namespace jam {

std::array<Vec3, 3> stress(const Packing& packing) {
  const Contacts& k = packing.contacts;
  const Grains& g = packing.grains;
  Vec3 row_x{}, row_y{}, row_z{};
  for (std::size_t c = 0; c < k.size(); ++c) {
    const std::uint32_t i = k.i[c];
    const Vec3 f = k.tangential_force[c] - k.normal_force[c] * k.normal[c];
    const Vec3 arm = k.j[c] < 0 ? k.point[c] - g.position[i] : branch(packing, c);
    row_x += f[0] * arm;
    row_y += f[1] * arm;
    row_z += f[2] * arm;
  }
  const double volume = box_volume(packing);
  std::array<Vec3, 3> sigma{row_x, row_y, row_z};
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
