#include "jamscape/protocol/box.hpp"

#include <cmath>
#include <numbers>

namespace jam {
namespace {

constexpr double half_bead_row = std::numbers::pi / 2;  // four walls of L beads of diameter 1, half of each: 4 L pi/8

}  // namespace

double BoxMeasure::volume(double length) const {
  if (walls != WallModel::beads) return std::pow(length, dimension);
  switch (convention) {
    case BoxConvention::half_beads:
      return length * length - half_bead_row * length;
    case BoxConvention::bead_centre:
      return length * length;
    case BoxConvention::inner_tangent:
      return (length - 1) * (length - 1);
  }
  return 0;
}

double BoxMeasure::length(double packing_fraction) const {
  const double wanted = grains / packing_fraction;
  if (walls != WallModel::beads) return std::pow(wanted, 1.0 / dimension);
  switch (convention) {
    case BoxConvention::half_beads:
      return half_bead_row / 2 + std::sqrt(half_bead_row * half_bead_row / 4 + wanted);
    case BoxConvention::bead_centre:
      return std::sqrt(wanted);
    case BoxConvention::inner_tangent:
      return 1 + std::sqrt(wanted);
  }
  return 0;
}

}  // namespace jam
