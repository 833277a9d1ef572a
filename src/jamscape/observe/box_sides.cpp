#include "jamscape/observe/box_sides.hpp"

#include <algorithm>

#include "jamscape/observe/box.hpp"

namespace jam {

int wall_side(const Wall& wall, int dimension) {
  const int axis = wall_axis(wall, dimension);
  return 2 * axis + (wall.normal[axis] < 0);
}

std::vector<Sides> touched_sides(const Packing& packing, const Bonds& bonds) {
  const Contacts& k = packing.contacts;
  std::vector<Sides> sides(packing.grains.size(), 0);
  for (const std::uint32_t c : bonds.wall_contact) {
    if (!(k.normal_force[c] > 0)) continue;
    const Wall& wall = packing.walls[static_cast<std::size_t>(-1 - k.j[c])];
    if (wall.kind == WallKind::cylinder) continue;
    const int side = wall_side(wall, packing.dimension);
    sides[k.i[c]] = static_cast<Sides>(sides[k.i[c]] | 1u << side);
  }
  return sides;
}

std::vector<Sides> sides_of_vertices(const ForceNetwork& network, std::vector<Sides> of_grains) {
  if (network.graph.vertices == of_grains.size()) return of_grains;
  std::vector<Sides> of_vertices;
  of_vertices.reserve(network.grain.size());
  for (const std::uint32_t grain : network.grain) of_vertices.push_back(of_grains[grain]);
  return of_vertices;
}

std::vector<BoxCopy> edge_images(const Packing& packing, const ForceNetwork& network) {
  std::vector<BoxCopy> images;
  if (std::none_of(packing.domain.periodic.begin(), packing.domain.periodic.end(), [](bool p) { return p; }))
    return images;
  images.reserve(network.contact.size());
  for (const std::uint32_t c : network.contact) {
    const auto& image = packing.contacts.image[c];
    images.push_back({image[0], image[1], image[2]});
  }
  return images;
}

std::array<std::array<double, 3>, 3> cell_edges(const Domain& cell) {
  std::array<std::array<double, 3>, 3> edges{};
  for (int k = 0; k < 3; ++k)
    for (int a = 0; a < 3; ++a)
      edges[static_cast<std::size_t>(k)][static_cast<std::size_t>(a)] = cell.upright() ? a == k : cell.edge(k)[a];
  return edges;
}

}  // namespace jam
