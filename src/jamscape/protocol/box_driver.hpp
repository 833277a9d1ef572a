// Discs or spheres in a box whose walls all move inward at once, or in a periodic box that shrinks.
#pragma once

#include "jamscape/dem/engine.hpp"
#include "jamscape/protocol/box.hpp"
#include "jamscape/protocol/engine_driver.hpp"

namespace jam {

template <int D>
class BoxDriver : public EngineDriver<Engine<D>> {
 public:
  BoxDriver(const SystemOptions& system, const TaskKey& key);

  void begin(const Leg& leg) override;
  bool reached(const Leg&) override { return false; }
  double packing_fraction() const override { return box_.packing_fraction(length()); }
  int set_threads(int wanted) override { return this->engine_.set_threads(wanted); }
  double work_per_glance() const override { return 2e4; }

 private:
  double plain_packing_fraction() const override { return box_.packing_fraction_plain(length()); }
  double length() const;

  BoxMeasure box_;
};

extern template class BoxDriver<2>;
extern template class BoxDriver<3>;

}  // namespace jam
