// steps: compress by `increment`, relax, and so on; one frame after each relaxation.
#pragma once

#include "jamscape/protocol/stages/stage.hpp"

namespace jam {

struct Steps {
  static constexpr StageTraits traits = {
      .text = "does so by an `increment` of packing fraction at a time and relaxes after each",
      .moves = true,
      .relaxes = true,
      .to_packing_fraction = true,
      .instead_of_frames = "frames_inside"};

  struct Options {
    double increment = 0.02;
    std::int64_t frames_inside = 0;

    template <class V>
    void describe(V& v) {
      v.option("increment", increment,
               {.text = "steps: packing fraction from one relaxation to the next, on a grid that ends at `to`",
                .min = 1e-6,
                .max = 1,
                .source = "S2 Sec. 3"});
      v.option("frames_inside", frames_inside,
               {.text = "steps: frames inside each increment, the last one just before its relaxation",
                .min = 0,
                .max = 1e6});
    }
    void forget_frames() { frames_inside = 0; }
  };

  static void write(const StageOptions& stage, BoxTimetable& table);
};

}  // namespace jam
