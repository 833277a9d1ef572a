// What a protocol drives: an engine and the walls around it, in one of two kinds. Both offer
//
//   engine()             the simulation
//   begin(leg)           sets the walls in motion for this leg
//   reached(leg)         a press leg has its force
//   work_per_glance      grain-steps between two glances at the clock: about a millisecond
//   packing_fraction()   now, in the study's convention; packing_fraction_plain() with the true grain area (volume)
#pragma once

#include "jamscape/dem/cluster_engine.hpp"
#include "jamscape/dem/engine.hpp"
#include "jamscape/protocol/box.hpp"
#include "jamscape/protocol/cluster_start.hpp"
#include "jamscape/protocol/plan.hpp"

namespace jam {

/// Discs or spheres in a box whose walls all move inward at once, or a periodic box that shrinks.
template <int D>
class BoxScene {
 public:
  static constexpr double work_per_glance = 2e4;

  BoxScene(const SystemOptions& system, const TaskKey& key);

  Engine<D>& engine() { return engine_; }
  void begin(const Leg& leg);
  bool reached(const Leg&) const { return false; }
  double packing_fraction() const { return box_.packing_fraction(length()); }
  double packing_fraction_plain() const { return box_.packing_fraction_plain(length()); }

 private:
  double length() const;

  BoxMeasure box_;
  Engine<D> engine_;
};

/// Rigid clusters in a container with a lid.
class ContainerScene {
 public:
  static constexpr double work_per_glance = 2500;

  ContainerScene(const SystemOptions& system, const TaskKey& key);

  ClusterEngine& engine() { return engine_; }
  void begin(const Leg& leg);
  bool reached(const Leg& leg) { return engine_.wall_force(lid())[1] >= leg.force; }
  /// Up to the lid, or to the highest body while the lid is not there yet.
  double packing_fraction() const;
  double packing_fraction_plain() const { return packing_fraction(); }

 private:
  ContainerScene(const SystemOptions& system, const TaskKey& key, const ClusterRoom& room);
  std::size_t lid() const { return engine_.walls().size() - 1; }

  Container container_;
  ClusterEngine engine_;
};

extern template class BoxScene<2>;
extern template class BoxScene<3>;

}  // namespace jam
