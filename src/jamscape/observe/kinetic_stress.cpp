#include "jamscape/observe/kinetic_stress.hpp"

#include "jamscape/observe/box.hpp"
#include "jamscape/observe/entry.hpp"

namespace jam {

std::array<Vec3, 3> kinetic_stress(const Packing& packing) {
  const Grains& g = packing.grains;
  std::array<Vec3, 3> sigma{};
  const double volume = box_volume(packing);
  double mass = 0;
  Vec3 momentum{};
  for (std::size_t i = 0; i < g.size(); ++i) {
    mass += g.mass[i];
    momentum += g.mass[i] * g.velocity[i];
  }
  if (!(volume > 0 && mass > 0)) return sigma;
  const Vec3 drift = (1 / mass) * momentum;
  for (std::size_t i = 0; i < g.size(); ++i) {
    const Vec3 v = g.velocity[i] - drift;
    for (int a = 0; a < packing.dimension; ++a)
      for (int b = 0; b < packing.dimension; ++b)
        sigma[static_cast<std::size_t>(a)][b] -= g.mass[i] * v[a] * v[b] / volume;
  }
  return sigma;
}

Measure kinetic_stress_measure() {
  const char* unit = "m d^(2-D)/tau_c^2";
  return frame_measure(
      {"kinetic_stress", "stress of the grains' motion",
       "sigma_ab = -(1/V) sum over grains of m (v - <v>)_a (v - <v>)_b, <v> = (sum m v)/(sum m), V as for stress; "
       "negative trace, kinetic_pressure = -trace/D. The measure stress is the contact part alone: while grains move "
       "the two add up. Elements with z are 0 in two dimensions. Missing where the velocities are "
       "not given.",
       "theory sec. 4"},
      {{"kinetic_stress_xx", unit, "not above 0"},
       {"kinetic_stress_yy", unit, "not above 0"},
       {"kinetic_stress_xy", unit, "shear stress"},
       {"kinetic_stress_zz", unit, "not above 0; 0 in two dimensions"},
       {"kinetic_stress_xz", unit, "shear stress; 0 in two dimensions"},
       {"kinetic_stress_yz", unit, "shear stress; 0 in two dimensions"},
       {"kinetic_pressure", unit, "-(trace of the kinetic stress)/D"}},
      [](const Snapshot& s) {
        const auto t = kinetic_stress(s.packing());
        const double trace = t[0][0] + t[1][1] + t[2][2];
        return std::vector<double>{
            t[0][0], t[1][1], t[0][1], t[2][2], t[0][2], t[1][2], (0 - trace) / s.packing().dimension};
      },
      {.known = {&Knowledge::velocities}});
}

}  // namespace jam
