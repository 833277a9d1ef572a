// The space between the walls as the centres of the bodies see it: which of them are away from the walls, and how large
// a sphere about each stays inside, so that pair functions need no correction at edges.
#pragma once

#include <array>
#include <vector>

#include "jamscape/packing/cell.hpp"
#include "jamscape/packing/packing.hpp"

namespace jam {

class Room {
 public:
  /// `layer`: no centre is closer to a wall than this (beside the bead of a bead wall).
  Room(const Packing& packing, double layer);

  /// Limited by two walls, and not periodic or across a cylinder.
  bool walled(int axis) const { return axis < dimension_ && !periodic(axis) && !across(axis); }
  bool round() const { return radius_ > 0; }  ///< a cylinder
  /// Between the two faces of an axis; of a tilted cell those that its reduced edges join (cell.hpp).
  double width(int axis) const { return faces_.width(axis); }
  double above_low(int axis, const Vec3& x) const { return faces_.above_low(axis, x); }
  double below_high(int axis, const Vec3& x) const { return faces_.below_high(axis, x); }
  double diameter() const { return 2 * radius_; }

  Vec3 margin{};            ///< from the walls of each axis
  double round_margin = 0;  ///< from the cylinder
  int thin = -1;            ///< an axis whose walls do not matter to place()

  struct Place {
    bool inside = false;  ///< beyond the margin of every wall
    double reach = 0;     ///< radius of the largest sphere about it that no wall and no periodic copy of itself cuts
  };
  Place place(const Vec3& x) const;

  /// Area (2D) or volume (3D) beyond the margins.
  double volume_inside() const;

  /// The centres, those of periodic sides taken modulo their length, and behind them their copies within `range` of the
  /// box.
  std::vector<Vec3> wrapped(std::vector<Vec3> points) const;
  std::vector<Vec3> with_copies(std::vector<Vec3> points, double range) const;

 private:
  bool across(int axis) const { return radius_ > 0 && axis != axis_; }

  bool periodic(int axis) const { return cell_.periodic[static_cast<std::size_t>(axis)]; }
  double period(int axis) const { return cell_.upright() ? width(axis) : norm(cell_.edge(axis)); }

  int dimension_;
  Domain cell_;
  Faces faces_;
  double layer_ = 0;
  int axis_ = -1;  // of the cylinder
  Vec3 centre_{};  // a point of its axis
  double radius_ = 0;
};

/// Area of a ring, volume of a spherical shell.
double shell_volume(int dimension, double inner, double outer);

}  // namespace jam
