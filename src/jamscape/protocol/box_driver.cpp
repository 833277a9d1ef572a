#include "jamscape/protocol/box_driver.hpp"

#include "jamscape/protocol/start.hpp"

namespace jam {

template <int D>
BoxDriver<D>::BoxDriver(const SystemOptions& system, const TaskKey& key)
    : EngineDriver<Engine<D>>(start<D>(system, key), system),
      box_(start_box(system, draw_diameters(system.grains, key)).measure) {}

template <int D>
double BoxDriver<D>::length() const {
  const Engine<D>& engine = this->engine_;
  if (engine.walls().empty()) return engine.box().length[0];
  return engine.walls()[1].position - engine.walls()[0].position;
}

template <int D>
void BoxDriver<D>::begin(const Leg& leg) {
  Engine<D>& engine = this->engine_;
  for (std::size_t w = 0; w < engine.walls().size(); ++w) {
    const double v = engine.walls()[w].high ? -leg.speed : leg.speed;
    if (engine.walls()[w].velocity != v) engine.set_wall_velocity(w, v);
  }
  if (engine.walls().empty()) engine.set_box_speed(leg.speed);
}

template class BoxDriver<2>;
template class BoxDriver<3>;

}  // namespace jam
