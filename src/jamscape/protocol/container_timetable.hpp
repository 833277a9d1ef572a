// Legs and frames of a container, as stages write them one after another: a frame at the end of each stage. Its frames
// go by the packing fraction that comes out.
#pragma once

#include <string>

#include "jamscape/protocol/plan.hpp"

namespace jam {

enum class FrameIs { plain, relaxed };

class ContainerTimetable {
 public:
  /// `height`: of the start.
  ContainerTimetable(const SystemOptions& system, double height);

  void begin_stage(const std::string& name) { stage_ = name; }
  /// Its name.
  const std::string& stage() const { return stage_; }
  double gravity() const { return gravity_; }
  double height() const { return height_; }
  double time_step() const { return dt_; }

  /// The stage's leg, with a frame at its end.
  void add(Leg leg, FrameIs frame = FrameIs::plain);

  Timetable finish() { return std::move(table_); }

 private:
  Timetable table_;
  double gravity_, height_, dt_;
  bool clock_known_ = true;  ///< all legs so far take a known time
  std::string stage_;
};

}  // namespace jam
