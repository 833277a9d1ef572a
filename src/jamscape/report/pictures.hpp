// Which stored packings are pictured: one realisation of each system, at a few packing fractions.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "jamscape/report/results.hpp"
#include "jamscape/study/task.hpp"
#include "jamscape/study/task_folder.hpp"

namespace jam {

struct PictureFrame {
  double rho;              ///< planned packing fraction; in a container the one found
  std::size_t stored;      ///< index in run.h5
  bool own;                ///< only here because it is the first where its system is jammed
  std::string stage = {};  ///< in a container, where it tells the frames apart
};

struct PictureSource {
  Task task;
  TaskFolder folder;
  std::vector<PictureFrame> frames;   ///< empty where no realisation is finished
  std::vector<PictureFrame> all;      ///< the frames there are to choose from, by packing fraction
  std::vector<LeftOut> damaged = {};  ///< realisations before this one whose frames could not be read
};

/// Per system of the study: its first finished realisation that can be read; the frames nearest to [report] pictures,
/// or a few of them (even_frames()), fewer where the packings are large; and the first frame at or above the point
/// where the system jams. Of containers all frames, or the last where the packings are large.
std::vector<PictureSource> choose_pictures(const Results& results);

}  // namespace jam
