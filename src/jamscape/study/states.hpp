// Which frames of a system curves over the packing fraction, and with them jamming points, are made of.
//
// Relaxed ones, unless more frames were taken in stages of several frames that relax nothing: a stage that relaxes
// after a compression adds its state to the curve of the compression, it does not replace it. A relaxed frame at the
// packing fraction of a frame of such a curve is no state of its own.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace jam {

struct FrameKind {
  std::string stage;
  double packing_fraction = 0;
  bool relaxed = false;
};

struct States {
  std::vector<std::size_t> frames;  ///< in order
  bool relaxed = false;             ///< all of them are
};

States find_states(std::span<const FrameKind> frames);

}  // namespace jam
