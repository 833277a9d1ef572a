#include "jamscape/observe/backbone.hpp"

#include "jamscape/observe/entry.hpp"

namespace jam {

Backbone backbone(const Packing& packing, const Bonds& bonds) {
  const Contacts& k = packing.contacts;
  Backbone b;
  std::vector<std::uint8_t> stays(bonds.grains.size());
  for (std::size_t i = 0; i < stays.size(); ++i) {
    stays[i] = !bonds.rattles(i);
    b.grains += stays[i];
  }
  std::size_t pairs = 0;
  for (const std::uint32_t c : bonds.contact) pairs += stays[k.i[c]] & stays[static_cast<std::size_t>(k.j[c])];
  if (b.grains > 0) b.z = 2 * static_cast<double>(pairs) / static_cast<double>(b.grains);
  return b;
}

Measure backbone_measure() {
  return frame_measure(
      {"backbone", "contact number without rattlers",
       "z_backbone = 2 N_pp'/N' after grains with fewer than two contacts (walls counted) are taken out, once and not "
       "recursively: N' grains that stay, N_pp' touching pairs of them",
       "S2 Sec. 4; theory sec. 4"},
      {{"z_backbone", "", "touching grains per grain, without rattlers, walls excluded; 0 without grains"},
       {"grains_backbone", "", "N', grains that are no rattlers"}},
      [](const Snapshot& s) {
        const Backbone b = backbone(s.packing(), s.bonds());
        return std::vector<double>{b.z, static_cast<double>(b.grains)};
      });
}

}  // namespace jam
