// compress: all walls move inward at constant speed.
#pragma once

#include "jamscape/protocol/stages/stage.hpp"

namespace jam {

struct Compress {
  static constexpr StageTraits traits = {.text = "moves all walls inward at constant speed",
                                         .moves = true,
                                         .to_packing_fraction = true,
                                         .on_user_frames = true};

  struct Options {
    double to = 0.9;
    double speed = 2.5e-5;
    std::int64_t frames = 0;
    std::vector<double> frames_at;

    template <class V>
    void describe(V& v) {
      v.option("to", to, {.text = "packing fraction at which the stage ends", .min = 0, .max = 2, .above_min = true});
      v.option("speed", speed,
               {.text = "speed of each wall, or of the lid",
                .unit = "d/tau_c",
                .min = 0,
                .max = 1,
                .above_min = true,
                .source = "S1 App. A"});
      v.option(
          "frames", frames,
          {.text = "number of frames, evenly spaced in packing fraction, both ends included", .min = 0, .max = 1e6});
      v.option("frames_at", frames_at, {.text = "packing fractions of further frames", .min = 0, .max = 2});
    }
    void forget_frames() {
      frames = 0;
      frames_at.clear();
    }
  };

  static void write(const StageOptions& stage, BoxTimetable& table);
};

}  // namespace jam
