// Which stored packings are pictured: one realisation of each system, at a few packing fractions.
#pragma once

#include <cstdint>
#include <vector>

#include "jamscape/report/results.hpp"
#include "jamscape/study/task.hpp"
#include "jamscape/study/task_folder.hpp"

namespace jam {

struct PictureFrame {
  double rho;          ///< planned packing fraction
  std::size_t stored;  ///< index in run.h5
  bool own;            ///< only here because it is the first above the rho_c of its system
};

struct PictureSource {
  Task task;
  TaskFolder folder;
  std::vector<PictureFrame> frames;  ///< empty where no realisation is finished
  std::vector<PictureFrame> all;     ///< every planned frame, by packing fraction
};

/// Per system of the study: its first finished realisation; the frames nearest to [report] pictures, or the last few at
/// multiples of .02; and the first frame at or above the system's rho_c.
std::vector<PictureSource> choose_pictures(const Results& results);

}  // namespace jam
