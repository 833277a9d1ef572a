// What a kind of stage is made of. Each kind has a file of its own with a struct that offers
//
//   static constexpr StageTraits traits          what others ask of it
//   struct Options                               its options, with describe(); keys are shared by all [[stage]] tables.
//                                                forget_frames() sets those that only say where frames are taken back
//                                                to their defaults: they name no simulation
//   static void write(const StageOptions&, BoxTimetable&)          its legs and frames in a box that closes in,
//   static void write(const StageOptions&, ContainerTimetable&)    and in a container; either one, or both
//
// and stands in the list of list.hpp. Names, refusals, `explain` and the reference come from there.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "jamscape/base/option.hpp"

namespace jam {

struct StageOptions;
class BoxTimetable;
class ContainerTimetable;

struct StageTraits {
  std::string_view text;             ///< what it does, after its name
  bool moves = false;                ///< walls or the lid, at `speed`
  bool relaxes = false;              ///< waits until the grains rest, by the relax_... options
  bool to_packing_fraction = false;  ///< ends at `to`
  bool on_user_frames = false;       ///< has `frames` and `frames_at`
  std::string_view instead_of_frames = "this stage has one frame, at its end";
};

}  // namespace jam
