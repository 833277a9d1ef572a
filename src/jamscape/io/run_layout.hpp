// What the writer and the reader of run files (run_file.hpp describes the layout) must agree on.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "jamscape/packing/packing.hpp"

namespace jam::run_layout {

inline constexpr std::int32_t version = 2;
/// Version 1 knew neither clusters nor cylinders, and is else the same.
inline constexpr std::int32_t oldest_version = 1;
/// The root attribute of files with a seal behind them.
inline constexpr const char* sealed = "sealed";

/// The components of a vector that are stored: all three, in 2D those in the plane, or out of it for rotations.
struct Components {
  int first, count;
};
inline Components in_plane(int dimension) { return {0, dimension}; }
inline Components rotation(int dimension) { return dimension == 2 ? Components{2, 1} : Components{0, 3}; }
inline constexpr Components all{0, 3};

inline constexpr std::pair<const char*, double EnergyLedger::*> energies[] = {
    {"energy_kinetic", &EnergyLedger::kinetic},     {"energy_elastic", &EnergyLedger::elastic},
    {"energy_damped", &EnergyLedger::damped},       {"energy_rubbed", &EnergyLedger::rubbed},
    {"energy_wall_work", &EnergyLedger::wall_work}, {"energy_gravity_work", &EnergyLedger::gravity_work}};

}  // namespace jam::run_layout
