// Tables that hold several frames of one packing, told apart by a column.
#pragma once

#include <optional>

#include "jamscape/io/csv.hpp"

namespace jam {

struct FrameRows {
  CsvFile table;                ///< the rows of one frame
  std::optional<double> frame;  ///< which, where a column says so
};

bool tells_frames(const CsvFile& csv);

/// A column frame, timestep, step, snapshot or time of one value needs no choice. Throws a data error where it holds
/// several and none is wanted, and where the wanted one is not there.
FrameRows one_frame(CsvFile csv, std::optional<double> wanted);

}  // namespace jam
