#include "jamscape/protocol/scene.hpp"

#include <algorithm>

#include "jamscape/protocol/start.hpp"

namespace jam {

template <int D>
BoxScene<D>::BoxScene(const SystemOptions& system, const TaskKey& key)
    : box_(start_box(system, draw_diameters(system.grains, key)).measure), engine_(start<D>(system, key)) {}

template <int D>
double BoxScene<D>::length() const {
  if (engine_.walls().empty()) return engine_.box().length[0];
  return engine_.walls()[1].position - engine_.walls()[0].position;
}

template <int D>
void BoxScene<D>::begin(const Leg& leg) {
  for (std::size_t w = 0; w < engine_.walls().size(); ++w) {
    const double v = engine_.walls()[w].high ? -leg.speed : leg.speed;
    if (engine_.walls()[w].velocity != v) engine_.set_wall_velocity(w, v);
  }
  if (engine_.walls().empty()) engine_.set_box_speed(leg.speed);
}

template class BoxScene<2>;
template class BoxScene<3>;

ContainerScene::ContainerScene(const SystemOptions& system, const TaskKey& key)
    : ContainerScene(system, key, cluster_room(system, key)) {}

ContainerScene::ContainerScene(const SystemOptions& system, const TaskKey& key, const ClusterRoom& room)
    : container_(room.container), engine_(cluster_start(system, key, room)) {}

void ContainerScene::begin(const Leg& leg) {
  const ClusterWall& wall = engine_.walls()[lid()];
  if (leg.kind == LegKind::press) engine_.place_wall(lid(), std::min(wall.position, engine_.highest(1)));
  engine_.set_wall_velocity(lid(), -leg.speed);
}

double ContainerScene::packing_fraction() const {
  return container_.packing_fraction(std::min(engine_.walls()[lid()].position, engine_.highest(1)));
}

}  // namespace jam
