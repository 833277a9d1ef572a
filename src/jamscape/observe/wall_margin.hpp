// Places away from the walls, for the option measure.force_margin of the force statistics: those farther from every
// wall than the margin (mean diameters; at most a sixth of the width), as for the reference grains of g(r). Distances
// are to the sides Domain::lo and hi that are not periodic, for bead walls the lines of bead centres, and to a
// cylinder.
#pragma once

#include <optional>

#include "jamscape/observe/options.hpp"
#include "jamscape/observe/room.hpp"

namespace jam {

class WallMargin {
 public:
  WallMargin(const Packing& packing, const MeasureOptions& options);

  /// Always so for a margin of 0.
  bool keeps(const Vec3& place) const { return !room_ || room_->place(place).inside; }
  /// In d, as used along an axis; 0 along periodic ones.
  double along(int axis) const { return room_ ? room_->margin[axis] : 0; }
  /// Part of the circle of a cylinder that is inside; 1 without one.
  double round_share() const {
    if (!room_ || !room_->round()) return 1;
    const double inside = 1 - 2 * room_->round_margin / room_->diameter();
    return inside * inside;
  }

 private:
  std::optional<Room> room_;
};

/// A room whose margins are `margin`, a length, or a sixth of a width where that is less.
Room room_with_margin(const Packing& packing, double margin, double layer);

}  // namespace jam
