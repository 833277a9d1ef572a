// What the drivers of both engines have in common.
#pragma once

#include <utility>

#include "jamscape/packing/wall_roles.hpp"
#include "jamscape/protocol/driver.hpp"
#include "jamscape/protocol/unbalanced.hpp"

namespace jam {

/// From floor to lid: along gravity where planes hold the grains, else the last axis.
int axis_of_height(const SystemOptions& system);

template <class Engine>
class EngineDriver : public Driver {
 public:
  void run_to(std::int64_t step) override { engine_.run(step - engine_.step()); }
  std::int64_t step() const override { return engine_.step(); }
  double kinetic_energy() const override { return engine_.kinetic_energy(); }
  ElasticEnergy elastic_energy() const override { return engine_.elastic_energy(); }
  double unbalanced() override { return unbalanced_part(engine_.record(), gravity_); }
  Packing record() override {
    Packing packing = engine_.record();
    packing.packing_fraction = packing_fraction();
    packing.packing_fraction_plain = plain_packing_fraction();
    give_roles(packing, height_axis_);
    return packing;
  }
  void save(Archive& archive) const override { engine_.save(archive); }
  void load(const Archive& archive) override { engine_.load(archive); }

 protected:
  template <class Setup>
  EngineDriver(const Setup& setup, const SystemOptions& system)
      : engine_(setup), gravity_(system.domain.gravity), height_axis_(axis_of_height(system)) {}

  /// With the true area (volume) of the grains.
  virtual double plain_packing_fraction() const = 0;

  Engine engine_;

 private:
  double gravity_;
  int height_axis_;
};

}  // namespace jam
