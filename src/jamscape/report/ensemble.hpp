// The long tables of DIR/ensemble (one row per system, frame, abscissa and quantity), put into curves.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "jamscape/report/results.hpp"

namespace jam {

struct Estimates {
  std::vector<double> mean, error;  ///< standard error; not a number where there is one realisation only
};

/// Mean and error of each quantity over the abscissae of one frame.
struct EnsembleFrame {
  double rho = 0;         ///< packing fraction: as planned, or what came out in a container
  std::vector<double> x;  ///< the same for all quantities, taken from the first; empty for the table of frames
  std::string first;
  std::map<std::string, Estimates> quantities;
};

struct SystemRows {
  std::map<std::int64_t, EnsembleFrame> frames;  ///< by index of the frame
  std::int64_t realisations = 0;             ///< the largest n
  bool container =
      false;  ///< its frames are ends of stages, and no curve over the packing fraction: the last one counts
};

/// One entry per system of the study; where frames follow relaxations, only those. `abscissa` names the column that
/// tells rows of a frame apart, or is empty.
std::vector<SystemRows> ensemble_rows(const Results& results, const Table& table, const std::string& abscissa);

}  // namespace jam
