// A stage that compresses, in a line.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "jamscape/protocol/stage_options.hpp"

namespace jam {

inline StageOptions compression(std::string name, double to, double speed, std::int64_t frames,
                                std::vector<double> frames_at = {}) {
  StageOptions stage;
  stage.name = std::move(name);
  stage.to = to;
  stage.speed = speed;
  stage.frames = frames;
  stage.frames_at = std::move(frames_at);
  return stage;
}

}  // namespace jam
