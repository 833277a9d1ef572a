// press: the lid of a container comes down until it carries `force`; one frame at that instant.
#pragma once

#include "jamscape/protocol/stages/stage.hpp"

namespace jam {

struct Press {
  static constexpr StageTraits traits = {.text = "brings the lid down until it carries `force`", .moves = true};

  struct Options {
    double force = 0;

    template <class V>
    void describe(V& v) {
      v.option("force", force,
               {.text = "press: what the lid carries in the end",
                .unit = "m d/tau_c^2",
                .min = 0,
                .max = 1e12,
                .source = "S3 Methods"});
    }
  };

  static void write(const StageOptions& stage, ContainerTimetable& table);
};

}  // namespace jam
