// Legs and frames of a box that closes in, as stages write them one after another. Its frames go by the packing
// fraction that is planned for them.
#pragma once

#include <string>
#include <vector>

#include "jamscape/protocol/plan.hpp"
#include "jamscape/protocol/start.hpp"

namespace jam {

class BoxTimetable {
 public:
  /// Stages count from start.packing_fraction where the lattice of this realisation begins below it, too: frames and
  /// steps lie on one grid in all realisations, and the first stage closes the rest of the way by itself.
  BoxTimetable(const StartBox& box, const SystemOptions& system);

  void begin_stage(const std::string& name) { stage_ = name; }
  /// Its name.
  const std::string& stage() const { return stage_; }
  /// Of the box, as wide as it is now.
  double packing_fraction() const { return box_.packing_fraction(length_); }
  /// From where stages count.
  double reached() const { return reached_; }

  /// Throws the usage error of a stage that ends below where it begins. on_grid: frames or steps are counted from where
  /// it begins.
  void refuse_below(double to, bool on_grid) const;
  /// The walls close in to this packing fraction, with frames on the way, in order.
  void close_to(double to, double speed, const std::vector<double>& frames);
  /// To where stages count from, if nothing has moved yet and the start lies below.
  void close_to_start();
  /// The walls stand still until the grains rest; one frame at the end.
  void rest(const RelaxOptions& options);

  /// The timetable; where no frame was asked for, its last instant is one.
  Timetable finish();

 private:
  bool at_start() const { return table_.legs.empty(); }
  void add_frame(double rho, std::int64_t offset, bool relaxed);

  Timetable table_;
  double dt_;
  BoxMeasure box_;
  double length_, reached_;
  double first_speed_ = 0;   ///< of the first stage that moves
  bool clock_known_ = true;  ///< no relaxation so far
  std::string stage_;
};

/// A packing fraction in a message: .84 as 0.84.
std::string short_number(double a);

}  // namespace jam
