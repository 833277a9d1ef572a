// The long tables of DIR/ensemble (one row per system, frame, abscissa and quantity), put into curves.
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "jamscape/report/results.hpp"

namespace jam {

struct Estimates {
  std::vector<double> mean, error;  ///< standard error; not a number where there is one realisation only
};

/// Mean and error of each quantity over the abscissae of one frame.
struct FrameRows {
  double rho = 0;         ///< planned packing fraction
  std::vector<double> x;  ///< the same for all quantities, taken from the first; empty for the table of frames
  std::string first;
  std::map<std::string, Estimates> quantities;
};

/// A container's packing fraction is what comes out, so that its frames have none as their target: they are told apart
/// by their index, and the last one is the final state.
inline bool has_target(const FrameRows& rows) { return std::isfinite(rows.rho); }

struct SystemRows {
  std::map<std::int64_t, FrameRows> frames;  ///< by index of the frame
  std::int64_t realisations = 0;             ///< the largest n
};

/// One entry per system of the study; where frames follow relaxations, only those. `abscissa` names the column that
/// tells rows of a frame apart, or is empty.
std::vector<SystemRows> ensemble_rows(const Results& results, const Table& table, const std::string& abscissa);

}  // namespace jam
