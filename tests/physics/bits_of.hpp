// One number for all bits of an instant.
#pragma once

#include <bit>
#include <cstdint>

#include "jamscape/packing/packing.hpp"

namespace jam {

inline void mix(std::uint64_t& h, double a) {
  h ^= std::bit_cast<std::uint64_t>(a);
  h *= 0x100000001b3u;
}

inline std::uint64_t bits_of(const Packing& p) {
  std::uint64_t h = 0xcbf29ce484222325u;
  for (std::size_t k = 0; k < p.grains.size(); ++k)
    for (int c = 0; c < 3; ++c)
      mix(h, p.grains.position[k][c]), mix(h, p.grains.velocity[k][c]), mix(h, p.grains.spin[k][c]);
  for (std::size_t k = 0; k < p.contacts.size(); ++k) {
    mix(h, p.contacts.normal_force[k]);
    for (int c = 0; c < 3; ++c) mix(h, p.contacts.tangential_force[k][c]);
  }
  for (const double e : {p.energy.kinetic, p.energy.elastic, p.energy.damped, p.energy.rubbed, p.energy.wall_work})
    mix(h, e);
  return h;
}

}  // namespace jam
